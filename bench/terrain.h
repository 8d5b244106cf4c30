// Terrains over square cells, each halved into two triangles one way or the other: two such
// surfaces with the same corners coincide along the sides of all cells.
#pragma once

#include <cstdint>
#include <functional>

#include "sectile/mesh.h"

namespace sectile::bench {

struct Terrain {
  std::uint32_t cells =
      10;  ///< in each direction, with sides of length 1; below is the plane z = 0
  std::function<double(std::uint32_t, std::uint32_t)> height;  ///< above 0
};

/// `rising`: cells are halved from their lower left corners.
PolygonMesh terrain_mesh(const Terrain& terrain, bool rising);

}  // namespace sectile::bench
