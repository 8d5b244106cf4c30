// Meshes that become solids by repair.
#pragma once

#include <string>

#include "sectile/mesh.h"
#include "sectile/repair.h"

namespace sectile::cli {

/// The faces of `more` beside those of `mesh`.
void append(PolygonMesh& mesh, const PolygonMesh& more);

/// Throws IllegalInput.
Solid repair_input(const std::string& name, const PolygonMesh& mesh, const RepairOptions& how,
                   RepairReport& report);

}  // namespace sectile::cli
