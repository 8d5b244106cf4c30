// Fans of very many triangles around one corner (search/hubs.h), told apart by directions.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/geometry.h"
#include "search/box_tree.h"
#include "search/hubs.h"
#include "selftest/triangle_surface.h"

namespace sectile {

class TriangleHubs {
 public:
  /// Of some of the triangles.
  TriangleHubs(const TriangleSurface& surface, const Geometry& geometry,
               std::span<const std::uint32_t> triangles);

  std::size_t count() const { return fans_.size(); }
  /// Per triangle: its hub, or Hubs::none. Empty if there is no hub.
  const std::vector<std::uint32_t>& of_triangle() const { return of_triangle_; }
  /// Do two triangles belong to one hub? Then for_each_pair() tells whether they may meet.
  bool same(std::uint32_t s, std::uint32_t t) const {
    return !of_triangle_.empty() && of_triangle_[s] != Hubs::none &&
           of_triangle_[s] == of_triangle_[t];
  }
  /// Calls visit(s, t) once for each two triangles that have more than the hub in common, and some
  /// others.
  template <class Visit>
  void for_each_pair(std::size_t hub, const Visit& visit) const {
    const std::vector<std::uint32_t>& fan = fans_[hub];
    const BoxTree tree(directions(hub));
    BoxTree::overlaps(tree, tree, [&](std::uint32_t i, std::uint32_t j) {
      if (i < j) visit(fan[i], fan[j]);
    });
  }

 private:
  std::vector<Box> directions(std::size_t hub) const;

  const TriangleSurface& surface_;
  const Geometry& geometry_;
  std::vector<PointId> points_;
  std::vector<std::vector<std::uint32_t>> fans_;  // per hub
  std::vector<std::uint32_t> of_triangle_;        // empty if there is no hub
};

}  // namespace sectile
