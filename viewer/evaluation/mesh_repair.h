// What a repair would make of a mesh, to be looked at before it is taken.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>

#include "picture/picture.h"
#include "sectile/repair.h"
#include "sectile/sectile.h"

namespace sectile::viewer {

/// What a person chooses.
struct RepairChoice {
  Rule rule = Rule::positive;
  bool close_holes = false;
  double stitch = 0;  ///< in the unit of the mesh
  bool operator==(const RepairChoice&) const = default;
};

struct RepairPreview {
  RepairChoice choice;
  RepairReport report;
  std::string refusal;  ///< why it cannot be repaired like this; or empty
  /// As it would come into the scene: legal, in doubles. Null if it is refused.
  std::shared_ptr<const PolygonMesh> mesh;
  std::shared_ptr<const SurfaceMesh> surface;
  double volume = 0;
  SolidCounts counts;
  std::size_t moved = 0;  ///< corners whose exact places are no doubles
  double largest_move = 0;
};

/// Throws Cancelled. `progress` is told the part done.
RepairPreview preview_repair(const PolygonMesh& mesh, const RepairChoice& choice,
                             const std::atomic<bool>* cancel,
                             const std::function<void(double)>& progress);

}  // namespace sectile::viewer
