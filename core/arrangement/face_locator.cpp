#include "arrangement/face_locator.h"

namespace sectile::arrangement {

FaceLocator::FaceLocator(const Facets& facets, const EdgeLines& lines,
                         const std::vector<std::uint8_t>& wanted, const Kernel& kernel)
    : facets_(facets), lines_(lines), kernel_(kernel), trees_(facets.face_count()) {
  constexpr std::uint32_t many = 32;
  const Geometry& g = kernel.geometry();
  std::vector<Box> boxes;
  for (std::size_t f = 0; f < facets.face_count(); ++f) {
    if (!wanted[f] || facets.size(f) < many) continue;
    boxes.clear();
    for (std::uint32_t c = facets.begin(f); c < facets.end(f); ++c) {
      Bounds bounds;
      bounds.add(g.position(facets.from(c)));
      bounds.add(g.position(facets.to(c)));
      boxes.push_back(bounds.box());
    }
    trees_[f] = std::make_unique<BoxTree>(boxes);
  }
}

}  // namespace sectile::arrangement
