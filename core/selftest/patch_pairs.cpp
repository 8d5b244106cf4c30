#include "selftest/patch_pairs.h"

#include <algorithm>
#include <utility>

#include "parallel/parallel.h"

namespace sectile {

PatchPairs::PatchPairs(const FlatPatches& patches, const TriangleSurface& surface,
                       const Geometry& geometry, const TriangleTree& rest)
    : patches_(patches),
      rest_(rest),
      trees_(patches.count()),
      boxes_(patches.count()),
      left_to_(patches.count()) {
  parallel::loop(0, patches.count(), [&](std::size_t i) {
    trees_[i] = TriangleTree(surface, geometry, patches[i].triangles);
    boxes_[i] = trees_[i].boxes(trees_[i].levels() - 1, 0).all();
  });
  const BoxTree tree(boxes_);
  const auto size = [&](std::uint32_t i) { return std::pair(patches[i].triangles.size(), i); };
  BoxTree::overlaps(tree, tree, [&](std::uint32_t i, std::uint32_t j) {
    if (size(j) < size(i)) left_to_[i].push_back(j);
  });
  for (auto& some : left_to_) std::sort(some.begin(), some.end());
}

}  // namespace sectile
