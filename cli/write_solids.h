// From solids to files of triangles.
#pragma once

#include <string>
#include <vector>

#include "interrupt.h"
#include "options.h"
#include "progress.h"
#include "summary.h"

namespace sectile::cli {

/// Writes every solid into its file, or none of them.
std::vector<Written> write_solids(const std::vector<std::string>& names,
                                  const std::vector<Solid>& solids, LengthUnit unit,
                                  const Options& options, Progress& progress,
                                  const Interrupt& interrupt);

struct NamedSolid {
  std::string name;
  Solid solid;
};

/// Writes all solids into one file, whose format must be able to hold them.
std::vector<Written> write_parts(const std::string& name, const std::vector<NamedSolid>& solids,
                                 LengthUnit unit, const Options& options, Progress& progress,
                                 const Interrupt& interrupt);

/// Writes a solid as the polygons from which it was read.
std::vector<Written> write_faces(const std::string& name, const Solid& solid,
                                 const PolygonMesh& mesh, const Options& options,
                                 const Interrupt& interrupt);

}  // namespace sectile::cli
