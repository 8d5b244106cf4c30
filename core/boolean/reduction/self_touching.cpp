// An operand may touch itself: one of its edges lies in one of its faces. Where that face is flush
// with a face of the other operand, no test of a pair has seen that it holds the edge's segments.
#include <algorithm>

#include "boolean/collect.h"
#include "boolean/face_location.h"
#include "boolean/line.h"
#include "boolean/reduction/contact_table.h"
#include "boolean/reduction/standing.h"
#include "search/face_corners.h"
#include "search/piece_tree.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

// The segments of edges of solid s in faces of the other one, by these faces.
class EdgesInFaces {
 public:
  EdgesInFaces(const Workspace& w, const Contacts& found, Operand s) : w_(w), found_(found), s_(s) {
    for (std::uint32_t i = 0; i < found.segments.size(); ++i)
      if (found.segments[i].on[s].is_edge() && found.segments[i].on[other(s)].is_face())
        order_.push_back(i);
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::uint32_t i, std::uint32_t j) { return face(i) < face(j); });
    for (std::uint32_t from = 0, to; from < order_.size(); from = to) {
      std::vector<PieceTree::Edge> edges;
      for (to = from; to < order_.size() && face(order_[to]) == face(order_[from]); ++to)
        edges.push_back({end(order_[to], 0), end(order_[to], 1)});
      groups_.push_back({face(order_[from]), from, PieceTree(edges)});
    }
  }

  /// Replaces `found` by the records in a face that come near a polygon, ascending.
  void find(FaceId in, std::span<const Vec3> near, std::vector<std::uint32_t>& found) const {
    found.clear();
    const auto group = std::partition_point(groups_.begin(), groups_.end(),
                                            [&](const Group& g) { return g.face < in; });
    if (group == groups_.end() || group->face != in) return;
    PieceTree::overlaps(group->tree, PieceTree(near), [&](std::uint32_t i, std::uint32_t) {
      found.push_back(order_[group->first + i]);
    });
    std::sort(found.begin(), found.end());
  }

 private:
  struct Group {
    FaceId face;
    std::uint32_t first;
    PieceTree tree;
  };

  FaceId face(std::uint32_t record) const { return found_.segments[record].on[other(s_)].face(); }
  const Vec3& end(std::uint32_t record, int which) const {
    return w_.geometry.position(found_.point(found_.segments[record].place[which]));
  }

  const Workspace& w_;
  const Contacts& found_;
  Operand s_;
  std::vector<std::uint32_t> order_;
  std::vector<Group> groups_;
};

class TouchedFaces {
 public:
  TouchedFaces(const Workspace& w, const Contacts& found, Operand s)
      : w_(w), kernel_(w.tests()), found_(found), s_(s), edges_(w, found, s) {}

  void operator()(const PairOfFaces& pair, SegmentRecords& out) const {
    if (patch().unbounded) return;
    const FaceId mine = pair.face[s_], across = pair.face[other(s_)];
    std::vector<std::uint32_t> near;
    with_outer_corners(patch().brep, w_.geometry, mine,
                       [&](std::span<const Vec3> corners) { edges_.find(across, corners, near); });
    for (const std::uint32_t r : near)
      if (!borders(found_.segments[r].on[s_].edge(), mine)) add(found_.segments[r], mine, out);
  }

 private:
  const Patch& patch() const { return w_.patch[s_]; }
  bool borders(EdgeId e, FaceId f) const {
    const Brep& brep = patch().brep;
    return brep.face_of(Brep::half_edge(e, 0)) == f || brep.face_of(Brep::half_edge(e, 1)) == f;
  }

  void add(const SegmentRecord& known, FaceId f, SegmentRecords& out) const {
    const Direction along = direction(known, patch().plane(f));
    std::vector<BoundaryItem> items;
    if (!find_items(known.place[0], f, items)) return;
    const Standing from = standing(kernel_, patch(), f, items, along);
    if (from.where == Standing::Where::outside) return;
    SegmentRecord record = known;
    record.end[s_][0] = from.entity;
    if (!find_items(known.place[1], f, items))
      throw InternalError("a segment leaves a face that touches itself");
    if (from.where == Standing::Where::along) {
      record.on[s_] = Brep::edge_of(from.half_edge);
      record.end[s_][1] = end_along(patch().brep, from.half_edge, items);
    } else {
      record.on[s_] = f;
      record.end[s_][1] = standing(kernel_, patch(), f, items, -along).entity;
    }
    out.push_back(record);
  }

  Direction direction(const SegmentRecord& record, PlaneId plane) const {
    const auto [a, b] = line_planes(patch(), Brep::half_edge(record.on[s_].edge()));
    const PlaneId across = kernel_.parallel(plane, a) ? b : a;
    return direction_between(kernel_, plane, across, found_.point(record.place[0]),
                             found_.point(record.place[1]));
  }

  // What the face's boundary has at a place; false if the place is outside of the face.
  bool find_items(PlaceId place, FaceId f, std::vector<BoundaryItem>& items) const {
    std::vector<Entity> found;
    locate(kernel_, patch(), f, Probe(kernel_, found_.point(place)), found);
    items.clear();
    for (const Entity entity : found) add_items(patch(), f, entity, items);
    std::sort(items.begin(), items.end());
    return !found.empty();
  }

  const Workspace& w_;
  const Kernel& kernel_;
  const Contacts& found_;
  Operand s_;
  EdgesInFaces edges_;
};

}  // namespace

void add_touched_faces(const Workspace& w, const ContactTable& table, Contacts& found) {
  std::vector<PairOfFaces> flush;
  for (const PairOfFaces& pair : table.pairs)
    if (pair.coplanar) flush.push_back(pair);
  if (flush.empty()) return;
  SegmentRecords more;
  for (const Operand s : both_operands) {
    const TouchedFaces touched(w, found, s);
    append(more, joined(collect<SegmentRecords>(
                     w, flush.size(), 64,
                     [&](std::size_t i, SegmentRecords& out) { touched(flush[i], out); })));
  }
  append(found.segments, more);
}

}  // namespace sectile
