// An operand may touch itself: one of its edges lies in one of its faces. Where that face is flush
// with a face of the other operand, no test of a pair has seen that it holds the edge's segments.
#include <algorithm>
#include <array>

#include "boolean/collect.h"
#include "boolean/face_location.h"
#include "boolean/line.h"
#include "boolean/reduction/contact_table.h"
#include "boolean/reduction/edges_in_faces.h"
#include "boolean/reduction/standing.h"
#include "search/face_corners.h"
#include "search/face_triangles.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

class TouchedFaces {
 public:
  TouchedFaces(const Workspace& w, const Contacts& found, std::span<const PairOfFaces> flush,
               Operand s)
      : w_(w),
        kernel_(w.tests()),
        found_(found),
        flush_(flush),
        s_(s),
        edges_(w, found, flush, s) {}

  void operator()(std::size_t pair, SegmentRecords& out) const {
    if (patch().unbounded) return;
    const FaceId mine = flush_[pair].face[s_];
    for (const std::uint32_t r : records_near(pair, mine))
      if (!borders(found_.segments[r].on[s_].edge(), mine)) add(found_.segments[r], mine, out);
  }

 private:
  const Patch& patch() const { return w_.patch[s_]; }
  // Those in the other face that come near this one.
  std::vector<std::uint32_t> records_near(std::size_t pair, FaceId mine) const {
    const Brep& brep = patch().brep;
    const EdgesInFaces::Beside beside = edges_.beside(flush_[pair]);
    std::vector<std::uint32_t> near;
    if (!beside.group) return near;
    if (may_lie_in_holes(mine, beside.group->records.size())) {
      for (const std::array<Vec3, 3>& triangle : face_triangles(brep, kernel_, mine))
        edges_.add_near(beside, triangle, near);
    } else {
      with_outer_corners(brep, w_.geometry, mine, [&](std::span<const Vec3> corners) {
        edges_.add_near(beside, corners, near);
      });
    }
    edges_.add_from_corners(pair, near);
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
      record.end[s_][1] = end_along(patch(), from.half_edge, items);
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
  std::span<const PairOfFaces> flush_;
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
    const TouchedFaces touched(w, found, flush, s);
    append(more,
           joined(collect<SegmentRecords>(
               w, flush.size(), 64, [&](std::size_t i, SegmentRecords& out) { touched(i, out); })));
  }
  append(found.segments, more);
}

}  // namespace sectile
