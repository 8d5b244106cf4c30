// Several meshes in one.
#pragma once

#include <cstdint>

#include "sectile/mesh.h"

namespace sectile::test {

/// The part's faces come after those of the mesh; its vertices stay its own.
inline void append(const PolygonMesh& part, PolygonMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
  mesh.face_sizes.insert(mesh.face_sizes.end(), part.face_sizes.begin(), part.face_sizes.end());
  for (const std::uint32_t i : part.indices) mesh.indices.push_back(first + i);
}

}  // namespace sectile::test
