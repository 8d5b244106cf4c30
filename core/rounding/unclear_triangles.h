// What is left for the exact test when corners were rounded.
#pragma once

#include "rounding/rounded_triangles.h"
#include "rounding/rounding_steps.h"

namespace sectile {

/// Of a mesh in which nothing was changed yet, ascending. Pairs with none of them meet in common
/// corners only, and did so all the way on which rounding moved their corners; triangles without
/// area are among them. As a rule there are hardly any: doubles tell of most pairs that rounding
/// did no harm. If there are none, the surface never met itself on that way, and nothing is inside
/// or outside now that was not before.
/// May throw Cancelled.
RoundedTriangles::Triangles unclear_triangles(const RoundedTriangles& mesh,
                                              const RoundingSteps& steps);

}  // namespace sectile
