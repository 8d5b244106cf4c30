// Numbers of a grid within a cone, however thin it is.
#pragma once

#include <span>
#include <vector>

#include "rounding/rounding_grid.h"

namespace sectile {

/// What is on the inner sides of some planes through one point.
struct ThinCone {
  Vec3 tip;                  ///< a place near the point
  Vec3 to_point;             ///< from there, less than a step
  std::vector<Vec3> inward;  ///< across the planes, of length 1
  Vec3 amid;                 ///< a direction to the inner sides of all planes, of length 1
};

/// Places that seem to be in a cone, at most four times so far from its tip in each coordinate, the
/// nearest first. If there are very few, none may be found. No numbers are used that are nearer to
/// each other than `least_step`.
std::vector<Vec3> numbers_in_cone(const RoundingGrid& grid, const ThinCone& cone, double far,
                                  double least_step);

}  // namespace sectile
