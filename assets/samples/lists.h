// The lists that make up all().
#pragma once

#include <vector>

#include "samples/samples.h"

namespace sectile::samples {

std::vector<Sample> overview_figures();     ///< figures 1 to 13
std::vector<Sample> coincidence_figures();  ///< figures 16 to 20, tables II and III
std::vector<Sample> sequence_figures();     ///< figures 21 to 23

/// Every face stays one of its own, though it be coplanar with its neighbour: the figures need
/// them.
Solid solid_of(const PolygonMesh& mesh);

Sample pair_sample(const char* name, const char* title, const char* figure, Operation operation,
                   const PolygonMesh& a, const PolygonMesh& b);

}  // namespace sectile::samples
