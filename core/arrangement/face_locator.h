// Is a point of a face's plane in the face?
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "arrangement/edge_lines.h"
#include "arrangement/middle.h"
#include "geometry/planar_ray.h"
#include "geometry/probe.h"
#include "search/outline_tree.h"

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
    if (const OutlineTree* outline = outlines_[face].get()) {
      const std::uint32_t first = facets_.begin(face);
      outline->cast_ray(
          place(point, ray), [&](std::uint32_t edge) { add(first + edge); },
          [&](std::uint32_t from, std::uint32_t to) {
            ray.pass(facets_.from(first + from), facets_.from(first + to));
          });
    } else {
      for (std::uint32_t c = facets_.begin(face); c < facets_.end(face) && !touched; ++c) add(c);
    }
    return touched || ray.odd();
  }

  /// Calls visit(corner) for the edges of a face that come near another one; all of a small face.
  template <class Visit>
  void for_each_near(std::uint32_t face, std::uint32_t other, const Visit& visit) const {
    if (const OutlineTree* outline = outlines_[face].get())
      outline->query(as_target(other),
                     [&](std::uint32_t edge) { visit(facets_.begin(face) + edge); });
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

  OutlineTree::Target as_target(std::uint32_t face) const;

  template <class Point>
  static OutlineTree::Place place(const Point& point, const PlanarRay<Point>& ray) {
    const auto [low_i, high_i] = bounds(point, ray.i());
    const auto [low_j, high_j] = bounds(point, ray.j());
    return {{low_i, low_j}, {high_i, high_j}};
  }
  static std::pair<double, double> bounds(const Probe& p, int axis) {
    const double at = component(p.position(), axis);
    return {at, at};
  }
  static std::pair<double, double> bounds(const Middle& p, int axis) { return p.bounds(axis); }

  const Facets& facets_;
  const EdgeLines& lines_;
  const Kernel& kernel_;
  std::vector<std::unique_ptr<OutlineTree>> outlines_;  // per face of many corners
};

}  // namespace sectile::arrangement
