// Blocks of neighbouring triangles that cannot meet each other.
//
// If all triangles of a block are seen along an axis from the same side, a point of the picture is
// covered as often as the block's rim winds around it. Where that is at most once, the block is the
// graph of a function, and no two of its triangles meet in more than edges and corners.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/kernel.h"
#include "selftest/triangle_surface.h"
#include "selftest/triangle_tree.h"

namespace sectile {

class FlatBlocks {
 public:
  FlatBlocks(const TriangleSurface& surface, const TriangleTree& tree, const Kernel& kernel);

  /// True: no two triangles of the node meet.
  bool flat(std::size_t level, std::size_t node) const {
    return level < flat_.size() && flat_[level][node] != 0;
  }

 private:
  class Worker;

  static constexpr std::size_t least_level = 1, greatest_level = 3;

  void note_sides(const TriangleSurface& surface, const TriangleTree& tree, const Kernel& kernel);

  std::vector<std::uint32_t> place_;              // per triangle: its number in the tree's order
  std::vector<std::vector<std::uint8_t>> sides_;  // per level: views in which all face the viewer
  std::vector<std::vector<std::uint8_t>> flat_;
};

}  // namespace sectile
