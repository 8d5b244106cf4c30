#include "arrangement/edge_uses.h"

#include <algorithm>

#include "parallel/sort.h"

namespace sectile::arrangement {

std::vector<EdgeUse> edge_uses(const Facets& facets, const std::vector<std::uint8_t>& wanted) {
  std::vector<EdgeUse> uses;
  for (std::size_t f = 0; f < facets.face_count(); ++f) {
    if (!wanted[f]) continue;
    for (std::uint32_t c = facets.begin(f); c < facets.end(f); ++c) {
      const PointId p = facets.from(c), q = facets.to(c);
      uses.push_back({std::min(p, q), std::max(p, q), c});
    }
  }
  parallel::sort(uses.begin(), uses.end());
  return uses;
}

}  // namespace sectile::arrangement
