// What all triangles of a node have in common.
#pragma once

#include <cstdint>
#include <vector>

#include "selftest/triangle_tree.h"

namespace sectile {

class NodeLabels {
 public:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;

  NodeLabels() = default;
  /// One label for each triangle, or none at all.
  NodeLabels(const TriangleTree& tree, const std::vector<std::uint32_t>& labels) {
    if (labels.empty()) return;
    const auto common = [](std::uint32_t g, std::uint32_t h) { return g == h ? g : none; };
    for (std::size_t level = 0; level < tree.levels(); ++level) {
      labels_.emplace_back(tree.nodes(level));
      for (std::size_t node = 0; node < labels_[level].size(); ++node) {
        const auto child = [&](std::size_t i) {
          return level > 0 ? labels_[level - 1][i] : labels[tree.order()[i]];
        };
        std::uint32_t label = child(8 * node);
        for (unsigned i = 1; i < tree.children(level, node); ++i)
          label = common(label, child(8 * node + i));
        labels_[level][node] = label;
      }
    }
  }

  /// Have all triangles of two nodes one label?
  bool same(std::size_t level, std::size_t a, std::size_t b) const {
    return !labels_.empty() && labels_[level][a] != none && labels_[level][a] == labels_[level][b];
  }

 private:
  std::vector<std::vector<std::uint32_t>> labels_;  // per level
};

}  // namespace sectile
