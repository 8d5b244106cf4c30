// Some faces of a solid, to be loaded.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "storage/solid_data.h"

namespace sectile::test {

/// About this share of all, always the same ones, ascending.
inline std::vector<FaceId> some_faces(const SolidData& solid, double share) {
  std::mt19937 random(1);
  std::bernoulli_distribution is_wanted(share);
  std::vector<FaceId> faces;
  for (std::uint32_t s = 0; s < solid.slots().size(); ++s)
    for (std::uint32_t f = 0; f < solid.slot(s).faces; ++f)
      if (is_wanted(random)) faces.push_back(solid.face(s, FaceId(f)));
  return faces;
}

}  // namespace sectile::test
