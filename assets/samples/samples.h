// The figures of Mäntylä's paper as solids, for tests, benchmarks, command line and viewer.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sectile/boolean.h"
#include "sectile/mesh.h"
#include "sectile/solid.h"

namespace sectile::samples {

struct Sample {
  std::string name;    ///< unique and fit for a file name
  std::string title;   ///< what is to be seen, in a few words
  std::string figure;  ///< of the paper
  PolygonMesh a_mesh, b_mesh;
  Solid a, b;                          ///< b is empty for a sample of splitting
  std::optional<Operation> operation;  ///< the figure's own
  std::optional<HalfSpace> plane;      ///< of a sample of splitting
};

/// All samples, in the order of the figures.
std::vector<Sample> all();
/// Throws std::out_of_range for an unknown name.
Sample get(const std::string& name);

}  // namespace sectile::samples
