// From polygons to a solid: the one way in for meshes, files and primitives.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "sectile/mesh.h"
#include "sectile/solid.h"
#include "storage/solid_data.h"

namespace sectile {

/// Polygons with holes: face f has face_loops[f] loops, the outer one first; the corners of all
/// loops stand one after another in `indices`.
struct Soup {
  std::vector<Vec3> positions;
  std::vector<std::uint32_t> face_loops;
  std::vector<std::uint32_t> loop_sizes;
  std::vector<std::uint32_t> indices;
};

/// A number that no imported mesh has had yet, for FaceSource::solid.
std::uint32_t new_origin();

/// Throws InvalidSolid as Solid::from_mesh does. Faces keep their number as FaceSource::face.
std::shared_ptr<const SolidData> import_soup(const Soup& soup, const ImportOptions& options = {});
std::shared_ptr<const SolidData> import_mesh(const PolygonMesh& mesh,
                                             const ImportOptions& options = {});

}  // namespace sectile
