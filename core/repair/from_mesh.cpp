// The one way in for meshes, legal or to be resolved.
#include "import/soup.h"
#include "sectile/repair.h"

namespace sectile {

Solid Solid::from_mesh(const PolygonMesh& mesh, const ImportOptions& options) {
  if (!options.resolve) return Solid(import_mesh(mesh, options));
  RepairOptions how;
  how.rule = *options.resolve;
  how.cancel = options.cancel;
  how.progress = options.progress;
  return repair(mesh, how, options.report);
}

}  // namespace sectile
