#include "evaluation/mesh_repair.h"

#include "picture/surface_mesh.h"
#include "sectile/rounding.h"

namespace sectile::viewer {

RepairPreview preview_repair(const PolygonMesh& mesh, const RepairChoice& choice,
                             const std::atomic<bool>* cancel,
                             const std::function<void(double)>& progress) {
  RepairPreview made;
  made.choice = choice;
  RepairOptions options;
  options.rule = choice.rule;
  options.close_holes = choice.close_holes;
  options.stitch = choice.stitch;
  options.cancel = cancel;
  options.progress = [&](double done) { progress(0.7 * done); };
  try {
    const Solid solid = repair(mesh, options, &made.report);
    if (solid.is_empty()) {
      made.refusal = "By this rule the faces bound no material: nothing would be left.";
      return made;
    }
    Rounding rounding;
    rounding.cancel = cancel;
    rounding.progress = [&](double done) { progress(0.7 + 0.2 * done); };
    RoundedMesh rounded = rounded_mesh(solid, rounding);
    made.moved = rounded.report.moved;
    made.largest_move = rounded.report.largest_move;
    made.volume = solid.volume();
    made.counts = solid.counts();
    made.surface = surface_mesh(solid);
    made.mesh = std::make_shared<const PolygonMesh>(std::move(rounded.mesh));
  } catch (const InvalidSolid& error) {
    made.refusal = error.what();
  } catch (const RoundingFailed& error) {
    made.refusal = error.what();
  }
  return made;
}

}  // namespace sectile::viewer
