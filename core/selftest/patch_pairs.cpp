#include "selftest/patch_pairs.h"

#include <algorithm>
#include <array>
#include <utility>

#include "parallel/parallel.h"

namespace sectile {

PatchPairs::PatchPairs(const FlatPatches& patches, const TriangleSurface& surface,
                       const Geometry& geometry, const TriangleTree& rest)
    : patches_(patches),
      surface_(surface),
      geometry_(geometry),
      rest_(rest),
      own_(patches.count()),
      boxes_(patches.count()),
      left_to_(patches.count()) {
  parallel::loop(0, patches.count(), [&](std::size_t i) {
    TriangleTree& tree = own_[i].tree;
    tree = TriangleTree(surface, geometry, patches[i].triangles);
    own_[i].slanted = SlantedNodes(surface, geometry, tree);
    boxes_[i] = tree.boxes(tree.levels() - 1, 0).all();
  });
  const BoxTree tree(boxes_);
  const auto size = [&](std::uint32_t i) { return std::pair(patches[i].triangles.size(), i); };
  BoxTree::overlaps(tree, tree, [&](std::uint32_t i, std::uint32_t j) {
    if (size(j) < size(i)) left_to_[i].push_back(j);
  });
  for (auto& some : left_to_) std::sort(some.begin(), some.end());
}

OrientedBox PatchPairs::around(std::uint32_t triangle) const {
  std::array<Vec3, 3> corners;
  for (std::size_t k = 0; k < 3; ++k)
    corners[k] = geometry_.position(surface_.corners[triangle][k]);
  return OrientedBox(corners);
}

}  // namespace sectile
