#include "repairing.h"

#include "problem.h"

namespace sectile::cli {

void append(PolygonMesh& mesh, const PolygonMesh& more) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), more.positions.begin(), more.positions.end());
  mesh.face_sizes.insert(mesh.face_sizes.end(), more.face_sizes.begin(), more.face_sizes.end());
  for (const std::uint32_t i : more.indices) mesh.indices.push_back(first + i);
}

Solid repair_input(const std::string& name, const PolygonMesh& mesh, const RepairOptions& how,
                   RepairReport& report) {
  try {
    return repair(mesh, how, &report);
  } catch (const InvalidSolid& error) {
    throw IllegalInput(name == "-" ? "standard input" : name, problems_of(error));
  }
}

}  // namespace sectile::cli
