#include "import/triangles/read_triangles.h"

#include "import/contacts.h"
#include "import/flat_edges.h"
#include "import/triangles/triangle_shells.h"

namespace sectile {
namespace {

// The test against itself needs all planes and all triangles in one structure.
void refuse_crossings(TriangleMesh& mesh, const FlatPart& part, const ImportOptions& options) {
  const TriangleSurface surface = surface_of({&mesh, 1}, {&part, 1});
  const Geometry geometry = geometry_of(mesh, surface);
  refuse_contacts(surface, mesh.source, Kernel(geometry), options);
}

}  // namespace

std::shared_ptr<SolidData> read_triangles(const SoupView& soup, const ImportOptions& options,
                                          const ImportSteps& steps) {
  std::optional<TriangleShells> read = read_triangle_shells(soup, steps);
  if (!read || read->shells.size() > 1) return nullptr;
  TriangleMesh& mesh = read->shells.front();
  steps.done(0.15);
  const std::uint32_t origin = new_origin();
  std::optional<FlatPart> part = flat_part_of(mesh, origin);
  if (!part) return nullptr;
  steps.done(0.2);
  if (!options.trusted) refuse_crossings(mesh, *part, steps.from_to(0.2, 0.9));
  return boundary_of(std::move(mesh), *std::move(part), origin, options.face_groups);
}

}  // namespace sectile
