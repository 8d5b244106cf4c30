// Point in solid, by exact rays.
//
// The face that a ray meets first tells by its side. Faces are looked at in groups that are met
// certainly before all others, as far as doubles tell; as faces of a solid are left and entered in
// turns, one group after the other says that the ray leaves the solid there, that it enters it, or,
// as at an edge that it only comes near to, nothing. A ray within the plane of very many faces,
// like the ground on which parts stand, comes near to them all: one from elsewhere tells more.
#pragma once

#include <optional>
#include <vector>

#include "boolean/workspace.h"
#include "storage/faces_on_ray.h"

namespace sectile {

class PointInSolid {
 public:
  PointInSolid(Workspace& w, Operand operand);

  /// Is a point, which is not on the boundary of the operand, inside it? May add to the workspace's
  /// geometry.
  bool operator()(PointId point);
  /// The same if doubles tell it.
  std::optional<bool> if_clear(PointId point);

 private:
  struct Group {
    double to = 0;
    int left = 0;  // how often the solid is left, less how often it is entered
    std::vector<FaceId> unclear;
    bool empty = true;
    void add(const FacesOnRay::Met& met);
  };
  std::optional<bool> follow_ray(PointId point, bool only_if_clear);
  int times_left(const Group& group, PointId point);

  Workspace& w_;
  Operand operand_;
  std::optional<FacesOnRay> faces_;  // none of a half-space
};

}  // namespace sectile
