// The shells of a large mesh of triangles, each on its straight way into blocks.
#pragma once

#include <optional>

#include "import/polygons.h"
#include "import/steps.h"
#include "import/triangles/flat_part.h"
#include "import/triangles/triangle_mesh.h"
#include "selftest/triangle_surface.h"
#include "storage/solid_data.h"

namespace sectile {

struct TriangleShells {
  std::vector<TriangleMesh> shells;  ///< in the order of the curve through all
  // Where several positions of the soup are one; empty where all are different.
  std::vector<Vec3> united_positions;         ///< of the points
  UnsetVector<std::uint32_t> united_corners;  ///< the points of all corners
  std::vector<std::uint32_t> input_vertex;    ///< per point: its first position
};

/// The shells of a soup. None if it is not large, or anything but triangles that have an area and
/// are closed surfaces around volume, each with two of them at each edge and one cycle of them
/// around each point. They refer to the soup, or to what is united.
std::optional<TriangleShells> read_triangle_shells(const SoupView& soup, const ImportSteps& steps);

/// The triangles that lie in one plane with a neighbour, with the planes that pin their edges. None
/// if they are more than a quarter: for these the general way is the shorter one. Throws
/// InvalidSolid where triangles are folded onto each other.
std::optional<FlatPart> flat_part_of(TriangleMesh& shell, std::uint32_t origin);

/// All triangles of some shells, for the test against itself, shell by shell.
TriangleSurface surface_of(std::span<TriangleMesh> shells, std::span<const FlatPart> parts);
/// The points of the input, and the planes of the surface in its order.
Geometry geometry_of(const TriangleMesh& mesh, const TriangleSurface& surface);

/// What a shell bounds. Where `groups` are given, coplanar triangles of one group become one face
/// (see join_flat_faces.h).
std::shared_ptr<SolidData> boundary_of(TriangleMesh&& shell, FlatPart&& part, std::uint32_t origin,
                                       std::optional<std::span<const std::uint32_t>> groups);

}  // namespace sectile
