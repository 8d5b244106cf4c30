// From solids to files of triangles.
#pragma once

#include <string>
#include <vector>

#include "options.h"
#include "progress.h"
#include "summary.h"

namespace sectile::cli {

/// Writes every solid into its file, or none of them.
std::vector<Written> write_solids(const std::vector<std::string>& names,
                                  const std::vector<Solid>& solids, LengthUnit unit,
                                  const Options& options, Progress& progress);

struct NamedSolid {
  std::string name;
  Solid solid;
};

/// Writes all solids into one file, whose format must be able to hold them.
std::vector<Written> write_parts(const std::string& name, const std::vector<NamedSolid>& solids,
                                 LengthUnit unit, const Options& options, Progress& progress);

/// Writes a solid as the polygons from which it was read.
std::vector<Written> write_faces(const std::string& name, const Solid& solid,
                                 const PolygonMesh& mesh, const Options& options);

}  // namespace sectile::cli
