// Faces cut into triangles.
#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "geometry/face_predicates.h"
#include "geometry/triangulation.h"
#include "storage/geometry_loader.h"
#include "topology/brep.h"

namespace sectile {

/// Some faces of a boundary. As a rule most of them are triangles: only what the others need is
/// copied, and computed with.
class FaceTriangles {
 public:
  FaceTriangles(const Brep& brep, const Geometry& geometry, std::vector<FaceId> faces)
      : brep_(brep), faces_(std::move(faces)) {
    GeometryLoader loader(geometry, needed_, 0);
    for (const FaceId f : faces_)
      if (!is_triangle(f)) load(f, loader);
  }

  /// Calls visit(face, a, b, c) with the points of each triangle, face by face.
  template <class Visit>
  void for_each(const Visit& visit) const {
    const Kernel kernel(needed_);
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::size_t next = 0;
    for (const FaceId f : faces_) {
      if (is_triangle(f)) {
        const HalfEdgeId h = brep_.loop_half_edge[brep_.outer_loop[f]];
        visit(f, from(h), from(brep_.next_of(h)), from(brep_.prev_of(h)));
        continue;
      }
      const Polygon& polygon = polygons_[next];
      const PointId* corners = corners_.data() + polygon.first_corner;
      triangulate_polygon(kernel, next++, triangles);
      for (const auto& t : triangles) visit(f, corners[t[0]], corners[t[1]], corners[t[2]]);
    }
  }

 private:
  struct Polygon {
    PlaneId plane;                         // in `needed_`
    std::size_t first_corner, first_loop;  // up to those of the next polygon
  };

  PointId from(HalfEdgeId h) const { return brep_.point_of(brep_.from(h)); }
  bool is_triangle(FaceId f) const {
    const LoopId outer = brep_.outer_loop[f];
    const HalfEdgeId h = brep_.loop_half_edge[outer];
    return !brep_.next_loop[outer].valid() && brep_.next_of(brep_.next_of(brep_.next_of(h))) == h;
  }

  void load(FaceId f, GeometryLoader& loader) {
    const std::size_t first = corners_.size();
    polygons_.push_back({loader.plane(brep_.plane[f]), first, loop_ends_.size()});
    for (LoopId l = brep_.outer_loop[f]; l.valid(); l = brep_.next_loop[l]) {
      for_each_in_loop(brep_, l, [&](HalfEdgeId h) {
        corners_.push_back(from(h));
        loaded_.push_back(loader.point(from(h)));
      });
      loop_ends_.push_back(static_cast<std::uint32_t>(corners_.size() - first));
    }
  }

  void triangulate_polygon(const Kernel& kernel, std::size_t i,
                           std::vector<std::array<std::uint32_t, 3>>& triangles) const {
    triangles.clear();
    const auto& [plane, first_corner, first_loop] = polygons_[i];
    const bool is_last = i + 1 == polygons_.size();
    const auto corners = std::span(loaded_).subspan(
        first_corner, (is_last ? loaded_.size() : polygons_[i + 1].first_corner) - first_corner);
    const auto loop_ends =
        std::span(loop_ends_)
            .subspan(first_loop,
                     (is_last ? loop_ends_.size() : polygons_[i + 1].first_loop) - first_loop);
    const int axis = kernel.main_axis(plane);
    triangulate_in_shape(
        FacePredicates(kernel, axis, kernel.normal(plane, axis) == Sign::negative, corners),
        loop_ends, triangles);
  }

  const Brep& brep_;
  std::vector<FaceId> faces_;
  Geometry needed_;
  std::vector<Polygon> polygons_;
  std::vector<PointId> corners_, loaded_;  // of the boundary, and the same in `needed_`
  std::vector<std::uint32_t> loop_ends_;   // counted from the polygon's first corner
};

}  // namespace sectile
