// The validator: checks every invariant of a solid (paper, section 2, criteria 1, 2 and 3').
#pragma once

#include <atomic>
#include <functional>
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

struct ValidationOptions {
  bool geometry = true;
  const std::atomic<bool>* cancel = nullptr;  ///< Cancelled is thrown soon after it is set
  std::function<void(double)> progress;       ///< is told the part done, by one thread at a time
};
std::vector<Violation> validate(const Solid& solid, const ValidationOptions& options);

}  // namespace sectile
