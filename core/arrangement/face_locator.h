// Is a point of a face's plane in the face?
#pragma once

#include <memory>
#include <vector>

#include "arrangement/edge_lines.h"
#include "arrangement/middle.h"
#include "geometry/planar_ray.h"
#include "geometry/probe.h"
#include "search/box_tree.h"

namespace sectile::arrangement {

/// For the faces whose edges have lines. A face of many corners has a tree over its edges.
class FaceLocator {
 public:
  FaceLocator(const Facets& facets, const EdgeLines& lines, const std::vector<std::uint8_t>& wanted,
              const Kernel& kernel);

  /// Inside, or on an edge or corner?
  template <class Point>
  bool contains(std::uint32_t face, const Point& point) const {
    if (facets_.polygons.is_triangle(face)) return in_triangle(face, point);
    PlanarRay<Point> ray(kernel_, facets_.plane[face], point);
    bool touched = false;
    const auto add = [&](std::uint32_t c) {
      touched = touched || ray.add(facets_.from(c), facets_.to(c), [&] {
        return lines_.across(c);
      }) != PlanarRay<Point>::Touch::nothing;
    };
    if (const BoxTree* tree = trees_[face].get()) {
      const int i = ray.i(), j = ray.j();
      tree->query(
          [&](const Box& b) {
            return b.low[j] <= most(point, j) && least(point, j) <= b.high[j] &&
                   b.high[i] >= least(point, i);
          },
          [&](std::uint32_t item) { add(facets_.begin(face) + item); });
    } else {
      for (std::uint32_t c = facets_.begin(face); c < facets_.end(face) && !touched; ++c) add(c);
    }
    return touched || ray.odd();
  }

  /// Calls visit(corner) for the edges of a face whose boxes meet a box; all of a small face.
  template <class Visit>
  void for_each_near(std::uint32_t face, const Box& box, const Visit& visit) const {
    if (const BoxTree* tree = trees_[face].get())
      tree->query([&](const Box& b) { return b.overlaps(box); },
                  [&](std::uint32_t item) { visit(facets_.begin(face) + item); });
    else
      for (std::uint32_t c = facets_.begin(face); c < facets_.end(face); ++c) visit(c);
  }

 private:
  // A triangle's third corner tells the inner side of each edge.
  template <class Point>
  bool in_triangle(std::uint32_t face, const Point& point) const {
    std::uint32_t c = facets_.begin(face);
    for (int i = 0; i < 3; ++i, c = facets_.next[c]) {
      const PlaneId plane = lines_.across(c);
      const Sign sign = point.side(plane);
      if (sign == Sign::zero) continue;
      if (sign != kernel_.side(facets_.to(facets_.next[c]), plane)) return false;
    }
    return true;
  }

  static double least(const Probe& p, int axis) { return component(p.position(), axis); }
  static double most(const Probe& p, int axis) { return component(p.position(), axis); }
  static double least(const Middle& p, int axis) { return p.least(axis); }
  static double most(const Middle& p, int axis) { return p.most(axis); }

  const Facets& facets_;
  const EdgeLines& lines_;
  const Kernel& kernel_;
  std::vector<std::unique_ptr<BoxTree>> trees_;  // per face
};

}  // namespace sectile::arrangement
