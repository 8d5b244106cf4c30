// Any number of solids at once.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "sectile/solid.h"

namespace sectile {

struct ArrangementOptions {
  const std::atomic<bool>* cancel = nullptr;  ///< set from outside to stop with Cancelled
  std::function<void(double)> progress;       ///< called now and then with 0 … 1
};

/// The regularised union of all solids, exactly; empty if there are none. A tree of Booleans of
/// neighbours, on all cores: faces that nothing crosses are shared, and what lies inside of one
/// solid does not meet the others. Where faces lie on each other, any of them gives its FaceSource.
Solid unite(std::span<const Solid> solids, const ArrangementOptions& options = {});

/// What all solids have in common, regularised; empty if there are none.
Solid intersect(std::span<const Solid> solids, const ArrangementOptions& options = {});

/// What is in `solid` and in none of the others, regularised.
Solid subtract(const Solid& solid, std::span<const Solid> others,
               const ArrangementOptions& options = {});

/// A part of space that is covered by certain solids and by no others. It may consist of several
/// pieces.
struct SolidCell {
  std::vector<std::uint32_t> operands;  ///< the numbers of the solids that cover it, ascending
  Solid solid;
};

/// All parts of space that are covered by different solids, from one arrangement of all faces: one
/// for each set of operands that occurs, ascending. Where two cells touch they have the same faces,
/// edges and vertices, with the same FaceSource, turned around.
std::vector<SolidCell> cells(std::span<const Solid> solids, const ArrangementOptions& options = {});

}  // namespace sectile
