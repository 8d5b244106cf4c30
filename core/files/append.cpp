#include "files/append.h"

#include <limits>
#include <string>

#include "sectile/errors.h"

namespace sectile {

void append(PolygonMesh& mesh, const PolygonMesh& more, std::string_view name) {
  const std::size_t first = mesh.positions.size();
  if (more.positions.size() > std::numeric_limits<std::uint32_t>::max() - first)
    throw FileError(std::string(name) + ": build: more positions than can be counted");
  mesh.positions.insert(mesh.positions.end(), more.positions.begin(), more.positions.end());
  mesh.face_sizes.insert(mesh.face_sizes.end(), more.face_sizes.begin(), more.face_sizes.end());
  mesh.indices.reserve(mesh.indices.size() + more.indices.size());
  for (const std::uint32_t index : more.indices)
    mesh.indices.push_back(static_cast<std::uint32_t>(first + index));
}

}  // namespace sectile
