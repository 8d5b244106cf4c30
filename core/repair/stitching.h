// Borders that nearly coincide.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "sectile/mesh.h"

namespace sectile {

/// Positions that are to become other ones: ascending by the old position.
using Moves = std::vector<std::pair<Vec3, Vec3>>;

/// Which points go where so that points at most `distance` apart are one: the closest first; a
/// point that others were moved to stays. Points that are neighbours stay apart.
Moves stitch(std::span<const Vec3> points,
             std::span<const std::pair<std::uint32_t, std::uint32_t>> neighbours, double distance);

/// Returns how many positions were changed.
std::size_t apply(const Moves& moves, std::vector<Vec3>& positions);

}  // namespace sectile
