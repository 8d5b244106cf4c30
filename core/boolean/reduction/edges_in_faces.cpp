#include "boolean/reduction/edges_in_faces.h"

#include <algorithm>

#include "boolean/reduction/edges_by_faces.h"

namespace sectile {

EdgesInFaces::EdgesInFaces(const Workspace& w, const Contacts& found,
                           std::span<const PairOfFaces> flush, Operand s)
    : w_(w), found_(found), s_(s), order_(edges_by_faces(found, s)) {
  for (std::size_t from = 0, to; from < order_.size(); from = to) {
    for (to = from; to < order_.size() && face(order_[to]) == face(order_[from]);) ++to;
    make_group(std::span(order_).subspan(from, to - from));
  }
  if (!w.patch[s].unbounded) find_from_corners(flush);
}

void EdgesInFaces::make_group(std::span<const std::uint32_t> records) {
  std::vector<EdgeFans::Ends> ends;
  ends.reserve(records.size());
  for (const std::uint32_t r : records) ends.push_back({end(r, 0), end(r, 1)});
  groups_.push_back({face(records[0]), records, EdgeFans(ends), {}, {}, {}});
  Group& group = groups_.back();
  if (group.fans.size() > 0)
    divide_by_fans(group);
  else
    group.trees.push_back(tree_of(records));
}

void EdgesInFaces::divide_by_fans(Group& group) const {
  const std::size_t count = group.fans.size();
  group.of_fan.resize(count + 1);
  for (std::size_t i = 0; i < group.records.size(); ++i) {
    const std::uint32_t fan = group.fans.of_edge()[i];
    group.of_fan[fan == EdgeFans::none ? count : fan].push_back(group.records[i]);
  }
  std::vector<Box> boxes;
  for (const std::vector<std::uint32_t>& some : group.of_fan) {
    group.trees.push_back(tree_of(some));
    Box& box = boxes.emplace_back();
    for (const std::uint32_t r : some) box.add(box_around(place(r, 0), place(r, 1)));
  }
  group.boxes = BoxTree(boxes);
}

PieceTree EdgesInFaces::tree_of(std::span<const std::uint32_t> records) const {
  std::vector<PieceTree::Edge> edges;
  edges.reserve(records.size());
  for (const std::uint32_t r : records) edges.push_back({place(r, 0), place(r, 1)});
  return PieceTree(edges);
}

// A corner's number is that of its point.
std::uint32_t EdgesInFaces::end(std::uint32_t record, int which) const {
  const Entity at = found_.segments[record].end[s_][static_cast<std::size_t>(which)];
  return at.is_vertex() ? w_.patch[s_].brep.point_of(at.vertex()).value() : EdgeFans::none;
}

const Vec3& EdgesInFaces::place(std::uint32_t record, int which) const {
  return w_.geometry.position(found_.point(found_.segments[record].place[which]));
}

const EdgesInFaces::Group* EdgesInFaces::find(FaceId in) const {
  const auto group = std::partition_point(groups_.begin(), groups_.end(),
                                          [&](const Group& g) { return g.face < in; });
  return group != groups_.end() && group->face == in ? &*group : nullptr;
}

EdgesInFaces::Beside EdgesInFaces::beside(const PairOfFaces& pair) const {
  const Group* const group = find(pair.face[other(s_)]);
  std::vector<std::uint32_t> around;
  if (!group || group->fans.size() == 0) return {group, around};
  const Brep& brep = w_.patch[s_].brep;
  for_each_in_face(brep, pair.face[s_], [&](HalfEdgeId h) {
    const std::uint32_t fan = group->fans.around(brep.point_of(brep.from(h)).value());
    if (fan != EdgeFans::none) around.push_back(fan);
  });
  std::sort(around.begin(), around.end());
  around.erase(std::unique(around.begin(), around.end()), around.end());
  return {group, around};
}

// An edge that begins in a corner of the face comes into it only where the face is seen in the
// edge's direction from there.
void EdgesInFaces::find_from_corners(std::span<const PairOfFaces> flush) {
  struct Seen {
    const Group* group;
    std::uint32_t fan, pair;
  };
  std::vector<Seen> seen;
  for (std::uint32_t i = 0; i < flush.size(); ++i) {
    const Beside near = beside(flush[i]);
    for (const std::uint32_t fan : near.fans) seen.push_back({near.group, fan, i});
  }
  const auto key = [](const Seen& a) { return std::pair(a.group, a.fan); };
  std::stable_sort(seen.begin(), seen.end(),
                   [&](const Seen& a, const Seen& b) { return key(a) < key(b); });
  for (std::size_t from = 0, to; from < seen.size(); from = to) {
    const Group& group = *seen[from].group;
    const std::uint32_t fan = seen[from].fan, corner = group.fans.hub(fan);
    std::vector<SeenArc> faces, edges;
    for (to = from; to < seen.size() && key(seen[to]) == key(seen[from]); ++to)
      faces.push_back(arc_of_face(flush[seen[to].pair].face[s_], corner));
    const std::vector<std::uint32_t>& records = group.of_fan[fan];
    for (const std::uint32_t record : records) edges.push_back(arc_of_edge(record, corner));
    for_each_pair_of_arcs(faces, edges, [&](std::uint32_t i, std::uint32_t j) {
      from_corners_.push_back({seen[from + i].pair, records[j]});
    });
  }
  std::sort(from_corners_.begin(), from_corners_.end());
}

SeenArc EdgesInFaces::arc_of_face(FaceId f, std::uint32_t corner) const {
  const Brep& brep = w_.patch[s_].brep;
  std::vector<Vec3> others;
  for_each_in_loop(brep, brep.outer_loop[f], [&](HalfEdgeId h) {
    const PointId p = brep.point_of(brep.from(h));
    if (p.value() != corner) others.push_back(w_.geometry.position(p));
  });
  return SeenArc::from_point(w_.geometry.position(PointId(corner)), others);
}

SeenArc EdgesInFaces::arc_of_edge(std::uint32_t record, std::uint32_t corner) const {
  const int far = end(record, 0) == corner ? 1 : 0;
  return SeenArc::from_point(place(record, 1 - far), std::span(&place(record, far), 1));
}

void EdgesInFaces::add_near(const Beside& beside, std::span<const Vec3> polygon,
                            std::vector<std::uint32_t>& found) const {
  const Group& group = *beside.group;
  const PieceTree hull(polygon);
  const auto add_of = [&](const PieceTree& tree, std::span<const std::uint32_t> records) {
    PieceTree::overlaps(tree, hull,
                        [&](std::uint32_t i, std::uint32_t) { found.push_back(records[i]); });
  };
  if (group.of_fan.empty()) return add_of(group.trees[0], group.records);
  Bounds bounds;
  for (const Vec3& p : polygon) bounds.add(p);
  const Box box = bounds.box();
  group.boxes.query([&](const Box& b) { return b.overlaps(box); },
                    [&](std::uint32_t fan) {
                      if (!std::ranges::binary_search(beside.fans, fan))
                        add_of(group.trees[fan], group.of_fan[fan]);
                    });
}

void EdgesInFaces::add_from_corners(std::size_t pair, std::vector<std::uint32_t>& found) const {
  const auto number = static_cast<std::uint32_t>(pair);
  for (auto at =
           std::lower_bound(from_corners_.begin(), from_corners_.end(), FromCorner{number, 0});
       at != from_corners_.end() && at->pair == number; ++at)
    found.push_back(at->record);
}

}  // namespace sectile
