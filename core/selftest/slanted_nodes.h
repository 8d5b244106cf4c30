// Oriented boxes for the nodes of long, thin, slanted triangles, of which axis-parallel boxes say
// little.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/geometry.h"
#include "search/oriented_box.h"
#include "selftest/triangle_surface.h"
#include "selftest/triangle_tree.h"

namespace sectile {

class SlantedNodes {
 public:
  SlantedNodes() = default;
  enum class Which { needles, all };
  /// Of nodes of such triangles, or of all. The tree must stay where it is.
  SlantedNodes(const TriangleSurface& surface, const Geometry& geometry, const TriangleTree& tree,
               Which which = Which::needles);

  /// Are there any?
  bool any() const { return !number_.empty(); }
  /// Are most of the least nodes such?
  bool are_most() const { return any() && 2 * boxes_[0].size() > tree_->nodes(0); }
  /// True: no triangle of a node meets one of another node of its level.
  bool apart(std::size_t level, std::size_t a, std::size_t b) const;
  /// True: no triangle of a node meets what is in a box.
  bool apart(std::size_t level, std::size_t node, const OrientedBox& box) const;

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;

  void find_needles(const TriangleSurface& surface, const Geometry& geometry);
  OrientedBox box_around(const TriangleSurface& surface, const Geometry& geometry,
                         std::size_t level, std::size_t node) const;
  bool are_beside(std::size_t leaf, std::size_t other) const;
  OrientedBox box(std::size_t level, std::size_t node) const;

  const TriangleTree* tree_ = nullptr;
  std::vector<std::vector<std::uint32_t>> number_;  // per level and node: its box, or none
  std::vector<std::vector<OrientedBox>> boxes_;     // per level
  std::vector<Vec3> corners_;                       // of all triangles in order, if all are such
};

}  // namespace sectile
