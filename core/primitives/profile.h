// Profiles checked and brought to one form.
#pragma once

#include <vector>

#include "sectile/primitives.h"

namespace sectile {

using ProfileLoop = std::vector<Vec2>;

/// The outer loop counter-clockwise, then the holes clockwise, without repeated points. Throws
/// std::invalid_argument if a loop has fewer than three corners, no area or a corner that is not
/// finite. That loops are simple and nested is the caller's promise.
std::vector<ProfileLoop> mended_loops(const Profile& profile);

}  // namespace sectile
