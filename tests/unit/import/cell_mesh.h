// Meshes of unit cells for tests: squares where a cell of the set meets one outside it.
#pragma once

#include <array>
#include <set>
#include <vector>

#include "sectile/mesh.h"

namespace sectile {

using Cell = std::array<int, 3>;

/// The boundary of a set of cells, turned inside out if `inwards`. Vertices are shared.
PolygonMesh cell_mesh(const std::set<Cell>& cells, bool inwards = false);

/// Eight shared vertices and six squares: 0 is low, 1 is at high x, 2 at high x and y, 3 at high y,
/// and 4 to 7 are above them. Faces: bottom, top, low y, high x, high y, low x.
PolygonMesh cube_mesh(const Vec3& low = {0, 0, 0}, double size = 1);

/// All of both.
PolygonMesh joined(const PolygonMesh& a, const PolygonMesh& b);
/// Every face turned around.
PolygonMesh turned_over(const PolygonMesh& mesh);

std::vector<std::vector<std::uint32_t>> faces_of(const PolygonMesh& mesh);
PolygonMesh with_faces(std::vector<Vec3> positions,
                       const std::vector<std::vector<std::uint32_t>>& faces);

}  // namespace sectile
