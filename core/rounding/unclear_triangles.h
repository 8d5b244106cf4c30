// What is left for the exact test when corners were rounded.
#pragma once

#include "rounding/rounded_triangles.h"
#include "rounding/rounding_steps.h"

namespace sectile {

/// Ascending.
struct UnclearTriangles {
  RoundedTriangles::Triangles all;
  RoundedTriangles::Triangles not_looked_at;  ///< of them: those of which nothing more is known
};

/// Of a mesh in which nothing was changed yet: pairs with none of them meet in common corners only,
/// and did so all the way on which rounding moved their corners. Triangles without area are among
/// them. As a rule there are hardly any: doubles tell of most pairs that rounding did no harm. May
/// throw Cancelled.
UnclearTriangles unclear_triangles(const RoundedTriangles& mesh, const RoundingSteps& steps);

}  // namespace sectile
