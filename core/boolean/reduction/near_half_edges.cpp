#include "boolean/reduction/near_half_edges.h"

#include <algorithm>
#include <optional>

#include "boolean/crowded_corners.h"
#include "search/face_corners.h"
#include "search/face_pieces.h"

namespace sectile {
namespace {

OutlineTree::Target as_target(const Workspace& w, Operand solid, FaceId face) {
  const Patch& patch = w.patch[solid];
  if (patch.unbounded) return {};
  if (const Patch::Outline* outline = patch.outline(face)) return outline->tree.as_target();
  return with_outer_corners(patch.brep, w.geometry, face, [](std::span<const Vec3> corners) {
    return OutlineTree::Target(corners);
  });
}

// What covers a face: triangles, if it leaves much of its box empty.
FacePieces pieces_of(const Workspace& w, Operand solid, FaceId face) {
  const Patch& patch = w.patch[solid];
  std::vector<PointId> points;
  const std::vector<std::uint32_t> loop_ends =
      collect_corners(patch.brep, face, [&](PointId p) { points.push_back(p); });
  std::vector<Vec3> places;
  places.reserve(points.size());
  for (const PointId p : points) places.push_back(w.geometry.position(p));
  FacePieces pieces;
  if (is_hollow(places, loop_ends))
    pieces.add_triangles(face.value(), w.tests(), patch.plane(face), points, loop_ends);
  else
    pieces.add(face.value(), std::span(places).first(loop_ends.front()));
  return pieces;
}

// Calls visit(edge) for the edges of an outline that come near a face of the other solid.
template <class Visit>
void for_each_near(const Workspace& w, const OutlineTree& outline, Operand other_solid,
                   FaceId across, const Visit& visit) {
  if (!outline.is_nested() || w.patch[other_solid].unbounded)
    return outline.query(as_target(w, other_solid, across), visit);
  std::vector<std::uint32_t> near;
  const FacePieces pieces = pieces_of(w, other_solid, across);
  for (std::size_t i = 0; i < pieces.count(); ++i)
    outline.query(OutlineTree::Target(pieces.corners(i)),
                  [&](std::uint32_t e) { near.push_back(e); });
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  for (const std::uint32_t e : near) visit(e);
}

// Of a face with crowded corners. What the other face has in common with the edges around one of
// these is in the line of both planes, if that goes through it; and if both faces are in one plane,
// and the other one has a corner there, in the directions in which it is seen.
class NearCrowdedCorners {
 public:
  using Fan = CrowdedCorners::Fan;

  NearCrowdedCorners(const Workspace& w, Operand solid, FaceId face, FaceId across)
      : w_(w),
        kernel_(w.tests()),
        patch_(w.patch[solid]),
        other_(w.patch[other(solid)]),
        face_(face),
        across_(across) {}

  /// Ascending.
  std::vector<HalfEdgeId> run(const CrowdedCorners& crowded) {
    const PieceTree polygon =
        with_outer_corners(other_.brep, w_.geometry, across_,
                           [](std::span<const Vec3> corners) { return PieceTree(corners); });
    const auto add = [&](HalfEdgeId h) { out_.push_back(h); };
    const PlaneId mine = patch_.plane(face_), plane = other_.plane(across_);
    const bool coplanar = kernel_.coplanar(mine, plane);
    for (const Fan& fan : crowded.fans()) {
      if (!coplanar && kernel_.side(fan.point, plane) == Sign::zero)
        add_in_line(fan, plane);
      else if (coplanar && has_corner_at(fan))
        add_in_sight(fan);
      else
        CrowdedCorners::query(fan, polygon, add);
    }
    crowded.query_others(polygon, add);
    std::sort(out_.begin(), out_.end());
    out_.erase(std::unique(out_.begin(), out_.end()), out_.end());
    return std::move(out_);
  }

 private:
  void add_in_line(const Fan& fan, PlaneId plane) {
    add_vertices(fan);
    for (const Sign sense : {Sign::positive, Sign::negative})
      add(fan, fan.corners.along(kernel_, {plane, sense}));
  }

  void add_in_sight(const Fan& fan) {
    add_vertices(fan);
    const Brep& brep = other_.brep;
    for_each_in_loop(brep, brep.outer_loop[across_], [&](HalfEdgeId h) {
      if (!is_at(fan, brep.from(h)) && !is_at(fan, brep.to(h)))
        add(fan,
            fan.corners.towards(kernel_, brep.point_of(brep.from(h)), brep.point_of(brep.to(h))));
    });
  }

  // That they are there.
  void add_vertices(const Fan& fan) { out_.insert(out_.end(), fan.speak.begin(), fan.speak.end()); }

  void add(const Fan& fan, const CornerFan::Range& range) {
    for (std::size_t i = 0; i < range.count; ++i) out_.push_back(fan.corners[range.first + i].h);
  }

  bool has_corner_at(const Fan& fan) const {
    bool has = false;
    for_each_in_loop(other_.brep, other_.brep.outer_loop[across_],
                     [&](HalfEdgeId h) { has = has || is_at(fan, other_.brep.from(h)); });
    return has;
  }
  bool is_at(const Fan& fan, VertexId v) const {
    const PointId p = other_.brep.point_of(v);
    return w_.geometry.position(p) == fan.place && kernel_.same_point(p, fan.point);
  }

  const Workspace& w_;
  const Kernel& kernel_;
  const Patch &patch_, &other_;
  FaceId face_, across_;
  std::vector<HalfEdgeId> out_;
};

// None where all half-edges are asked for.
const CrowdedCorners* crowded_corners(const Workspace& w, Operand solid, FaceId face) {
  const Patch& patch = w.patch[solid];
  if (patch.crowded.empty() || w.patch[other(solid)].unbounded) return nullptr;
  return patch.crowded_corners(face);
}

}  // namespace

bool near_half_edges(const Workspace& w, Operand solid, FaceId face, FaceId across,
                     std::vector<SidedHalfEdge>& out) {
  const Patch& patch = w.patch[solid];
  if (const CrowdedCorners* crowded = crowded_corners(w, solid, face)) {
    for (const HalfEdgeId h : NearCrowdedCorners(w, solid, face, across).run(*crowded))
      out.push_back({h, {}, {}});
    return false;
  }
  if (const Patch::Outline* outline = patch.outline(face)) {
    for_each_near(w, outline->tree, other(solid), across, [&](std::uint32_t edge) {
      out.push_back({outline->half_edges[edge], {}, {}});
    });
    return false;
  }
  for_each_in_face(patch.brep, face, [&](HalfEdgeId h) { out.push_back({h, {}, {}}); });
  return true;
}

}  // namespace sectile
