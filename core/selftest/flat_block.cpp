#include "selftest/flat_block.h"

#include <algorithm>

#include "parallel/parallel.h"
#include "parallel/scratch.h"
#include "selftest/node_labels.h"
#include "selftest/rim_sweep.h"

namespace sectile {
namespace {

// Bit k: seen against axis k, the triangle is counter-clockwise; bit 3 + k: seen along it.
std::uint8_t sides_of(const PlaneValue& plane) {
  unsigned bits = 0;
  for (unsigned k = 0; k < 3; ++k) {
    if (plane.n[k] > plane.n_error) bits |= 1u << k;
    if (plane.n[k] < -plane.n_error) bits |= 8u << k;
  }
  return static_cast<std::uint8_t>(bits);
}

}  // namespace

class FlatBlocks::Worker {
 public:
  Worker(FlatBlocks& blocks, const TriangleSurface& surface, const TriangleTree& tree,
         const Kernel& kernel)
      : blocks_(blocks), surface_(surface), tree_(tree), sweep_(kernel) {}

  /// Marks the node, or what is flat below it.
  void run(std::size_t level, std::size_t node) {
    if (is_flat(level, node)) {
      mark(level, node);
    } else if (level > least_level) {
      for (unsigned i = 0; i < tree_.children(level, node); ++i) run(level - 1, 8 * node + i);
    }
  }

 private:
  bool is_flat(std::size_t level, std::size_t node) {
    const unsigned sides = blocks_.sides_[level][node];
    if (sides == 0) return false;
    find_rim(level, node);
    for (int view = 0; view < 6; ++view)
      if ((sides >> view & 1u) != 0) return sweep_.winds_once(rim_, view % 3, view >= 3);
    return false;
  }

  void find_rim(std::size_t level, std::size_t node) {
    rim_.clear();
    const auto [begin, end] = tree_.range(level, node);
    for (std::uint32_t i = begin; i < end; ++i) {
      const std::uint32_t t = tree_.order()[i];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t mate = surface_.mate[t][k];
        const bool whole = (mate & TriangleSurface::partial) == 0;
        if (whole && blocks_.place_[mate] >= begin && blocks_.place_[mate] < end) continue;
        rim_.push_back({surface_.corners[t][k], surface_.corners[t][k < 2 ? k + 1 : 0]});
      }
    }
  }

  void mark(std::size_t level, std::size_t node) {
    blocks_.flat_[level][node] = 1;
    if (level == 0) return;
    for (unsigned i = 0; i < tree_.children(level, node); ++i) mark(level - 1, 8 * node + i);
  }

  FlatBlocks& blocks_;
  const TriangleSurface& surface_;
  const TriangleTree& tree_;
  RimSweep sweep_;
  std::vector<RimEdge> rim_;
};

void FlatBlocks::note_sides(const TriangleSurface& surface, const TriangleTree& tree,
                            const Kernel& kernel) {
  place_.assign(surface.size(), NodeLabels::none);  // far from all, unless it is in the tree
  for (std::size_t level = 0; level < flat_.size(); ++level)
    sides_.emplace_back(tree.nodes(level), std::uint8_t(63));
  parallel::loop(parallel::Range<std::size_t>(0, sides_[0].size(), 256), [&](const auto& range) {
    for (std::size_t node = range.begin(); node < range.end(); ++node) {
      const auto [begin, end] = tree.range(0, node);
      for (std::uint32_t i = begin; i < end; ++i) {
        const std::uint32_t t = tree.order()[i];
        place_[t] = i;
        sides_[0][node] &= sides_of(kernel.value(surface.plane[t]));
      }
    }
  });
  for (std::size_t level = 1; level < sides_.size(); ++level)
    for (std::size_t node = 0; node < sides_[level].size(); ++node)
      for (unsigned i = 0; i < tree.children(level, node); ++i)
        sides_[level][node] &= sides_[level - 1][8 * node + i];
}

FlatBlocks::FlatBlocks(const TriangleSurface& surface, const TriangleTree& tree,
                       const Kernel& kernel) {
  if (tree.levels() <= least_level) return;
  const std::size_t levels = std::min(tree.levels(), greatest_level + 1), top = levels - 1;
  for (std::size_t level = 0; level < levels; ++level)
    flat_.emplace_back(tree.nodes(level), std::uint8_t(0));
  note_sides(surface, tree, kernel);
  parallel::Scratch<Worker> workers([&] { return Worker(*this, surface, tree, kernel); });
  parallel::loop(0, tree.nodes(top), [&](std::size_t node) {
    workers.lend([&](Worker& worker) { worker.run(top, node); });
  });
}

}  // namespace sectile
