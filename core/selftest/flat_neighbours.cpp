#include "selftest/flat_neighbours.h"

#include <tbb/parallel_for.h>

#include "selftest/node_labels.h"

namespace sectile {
namespace {

// Faces of fewer triangles are not worth a look.
constexpr std::uint32_t many = 8;

class FlatNeighbours {
 public:
  FlatNeighbours(const TriangleSurface& surface, const Kernel& kernel)
      : surface_(surface), kernel_(kernel), size_(surface.face.back() + 1, 0) {
    for (const std::uint32_t f : surface.face) ++size_[f];
    for (std::size_t f = 0; f < surface.doubtful.size(); ++f)
      if (surface.doubtful[f] != 0) size_[f] = 0;
  }

  std::vector<std::uint32_t> find() const {
    std::vector<std::uint32_t> found(surface_.size(), NodeLabels::none);
    tbb::parallel_for(std::size_t(0), surface_.size(), [&](std::size_t t) {
      for (int k = 0; k < 3 && found[t] == NodeLabels::none; ++k)
        found[t] = beside(static_cast<std::uint32_t>(t), k);
    });
    return found;
  }

 private:
  // The face across an edge, if it is large and the triangle stands on it with just this edge.
  std::uint32_t beside(std::uint32_t t, int k) const {
    if ((surface_.mate[t][static_cast<std::size_t>(k)] & TriangleSurface::partial) != 0)
      return NodeLabels::none;
    const std::uint32_t across = surface_.neighbour(t, k), face = surface_.face[across];
    if (face == surface_.face[t] || size_[face] < many) return NodeLabels::none;
    const PointId apex = surface_.corners[t][static_cast<std::size_t>(k > 0 ? k - 1 : 2)];
    return kernel_.side(apex, surface_.plane[across]) == Sign::zero ? NodeLabels::none : face;
  }

  const TriangleSurface& surface_;
  const Kernel& kernel_;
  std::vector<std::uint32_t> size_;  // per face: its triangles; none if they may overlap
};

}  // namespace

std::vector<std::uint32_t> flat_neighbours(const TriangleSurface& surface, const Kernel& kernel) {
  if (surface.face.back() + 1 == surface.size()) return {};
  return FlatNeighbours(surface, kernel).find();
}

}  // namespace sectile
