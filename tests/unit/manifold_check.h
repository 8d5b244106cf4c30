// Is a mesh a manifold, when equal positions are one vertex? Nothing of the library is asked.
#pragma once

#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "sectile/mesh.h"

namespace sectile::test {

/// What is wrong, in words; empty if nothing is.
inline std::string manifold_fault(const PolygonMesh& mesh) {
  using Place = std::array<double, 3>;
  using Edge = std::array<Place, 2>;
  std::map<Edge, int> edges;
  std::map<Place, std::map<Place, Place>> around;  // from each neighbour to the next one
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    Place p[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& v = mesh.positions[mesh.indices[i + k]];
      p[k] = {v.x + 0.0, v.y + 0.0, v.z + 0.0};
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const Place &a = p[k], &b = p[(k + 1) % 3], &c = p[(k + 2) % 3];
      ++edges[Edge{std::min(a, b), std::max(a, b)}];
      if (!around[a].emplace(b, c).second) return "an edge has two triangles on one side";
    }
  }
  for (const auto& [edge, count] : edges)
    if (count != 2) return "an edge has " + std::to_string(count) + " triangles";
  for (const auto& [place, next] : around) {
    std::size_t steps = 0;
    const Place start = next.begin()->first;
    Place at = start;
    do {
      const auto step = next.find(at);
      if (step == next.end()) return "the triangles around a vertex are not closed";
      at = step->second;
      ++steps;
    } while (at != start && steps <= next.size());
    if (steps != next.size()) return "a vertex has several fans";
  }
  return {};
}

}  // namespace sectile::test
