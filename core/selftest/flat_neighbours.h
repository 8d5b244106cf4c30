// Triangles that stand on a flat face of many triangles, as the sides of a cone stand on its base,
// and meet it where they must and nowhere else.
//
//            .        The boxes of a cone's sides overlap those of all triangles of the base near
//           /|\       them: pairs that one look at the plane of the base settles at once.
//          / | \      .
//     ----/--|--\---- .
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/kernel.h"
#include "selftest/triangle_surface.h"

namespace sectile {

/// Per triangle: a flat face that it stands on, or NodeLabels::none. One that does meets the face's
/// plane in corners and edges that it shares with the face, and is on one side of it otherwise.
/// Empty if there are none.
std::vector<std::uint32_t> flat_neighbours(const TriangleSurface& surface, const Kernel& kernel);

}  // namespace sectile
