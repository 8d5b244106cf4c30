// The validator: checks every invariant of a solid (paper, section 2, criteria 1, 2 and 3').
#pragma once

#include <string>
#include <vector>

#include "sectile/solid.h"

namespace sectile {

struct Violation {
  std::string what;  ///< in words, with the ids of the entities concerned
  Vec3 where;        ///< a place near it
};

/// Checks links, loops, planes, edges and orientation, and with `geometry` also that no two faces
/// cross (criterion 3'). An empty list means that the solid is legal.
std::vector<Violation> validate(const Solid& solid, bool geometry = true);

}  // namespace sectile
