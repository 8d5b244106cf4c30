// Faces cut into triangles, one face after the other.
#pragma once

#include <array>
#include <vector>

#include "geometry/face_predicates.h"
#include "geometry/triangulation.h"
#include "topology/brep.h"

namespace sectile {

class FaceTriangles {
 public:
  FaceTriangles(const Brep& brep, const Geometry& geometry) : brep_(brep), kernel_(geometry) {}

  /// Calls visit(a, b, c) with the points of each triangle.
  template <class Visit>
  void of(FaceId face, Visit&& visit) {
    corners_.clear();
    loop_ends_.clear();
    triangles_.clear();
    for (LoopId l = brep_.outer_loop[face]; l.valid(); l = brep_.next_loop[l]) {
      for_each_in_loop(brep_, l,
                       [&](HalfEdgeId h) { corners_.push_back(brep_.point_of(brep_.from(h))); });
      loop_ends_.push_back(static_cast<std::uint32_t>(corners_.size()));
    }
    const PlaneId plane = brep_.plane[face];
    const int axis = kernel_.main_axis(plane);
    const FacePredicates exact(kernel_, axis, kernel_.normal(plane, axis) == Sign::negative,
                               corners_);
    triangulate(exact, std::span<const std::uint32_t>(loop_ends_), triangles_);
    for (const auto& t : triangles_) visit(corners_[t[0]], corners_[t[1]], corners_[t[2]]);
  }

 private:
  const Brep& brep_;
  const Kernel kernel_;
  std::vector<PointId> corners_;
  std::vector<std::uint32_t> loop_ends_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace sectile
