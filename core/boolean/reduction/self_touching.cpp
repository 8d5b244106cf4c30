// An operand may touch itself: one of its edges lies in one of its faces. Where that face is flush
// with a face of the other operand, no test of a pair has seen that it holds the edge's segments.
#include <algorithm>
#include <array>

#include "boolean/collect.h"
#include "boolean/face_location.h"
#include "boolean/line.h"
#include "boolean/reduction/contact_table.h"
#include "boolean/reduction/standing.h"
#include "search/face_corners.h"
#include "search/face_triangles.h"
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
      groups_.push_back({face(order_[from]), from, to, PieceTree(edges)});
    }
  }

  /// How many records there are in a face.
  std::size_t count(FaceId in) const {
    const Group* group = find(in);
    return group ? group->end - group->first : 0;
  }
  /// Adds the records in a face that come near a polygon.
  void add_near(FaceId in, std::span<const Vec3> polygon, std::vector<std::uint32_t>& found) const {
    const Group* group = find(in);
    if (!group) return;
    PieceTree::overlaps(group->tree, PieceTree(polygon), [&](std::uint32_t i, std::uint32_t) {
      found.push_back(order_[group->first + i]);
    });
  }

 private:
  struct Group {
    FaceId face;
    std::uint32_t first, end;
    PieceTree tree;
  };

  const Group* find(FaceId in) const {
    const auto group = std::partition_point(groups_.begin(), groups_.end(),
                                            [&](const Group& g) { return g.face < in; });
    return group != groups_.end() && group->face == in ? &*group : nullptr;
  }

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
    for (const std::uint32_t r : records_near(mine, across))
      if (!borders(found_.segments[r].on[s_].edge(), mine)) add(found_.segments[r], mine, out);
  }

 private:
  const Patch& patch() const { return w_.patch[s_]; }
  // Those in a face that come near another one.
  std::vector<std::uint32_t> records_near(FaceId mine, FaceId across) const {
    const Brep& brep = patch().brep;
    std::vector<std::uint32_t> near;
    if (may_lie_in_holes(mine, edges_.count(across))) {
      for (const std::array<Vec3, 3>& triangle : face_triangles(brep, kernel_, mine))
        edges_.add_near(across, triangle, near);
    } else {
      with_outer_corners(brep, w_.geometry, mine, [&](std::span<const Vec3> corners) {
        edges_.add_near(across, corners, near);
      });
    }
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    return near;
  }

  // Very many of so many? As where rings lie in rings.
  bool may_lie_in_holes(FaceId f, std::size_t records) const {
    const Brep& brep = patch().brep;
    if (!brep.next_loop[brep.outer_loop[f]].valid()) return false;
    std::size_t corners = 0;
    for_each_in_face(brep, f, [&](HalfEdgeId) { ++corners; });
    return records > corners;
  }

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
