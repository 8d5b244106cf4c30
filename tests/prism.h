// Prisms, as triangles.
#pragma once

#include <array>
#include <cstdint>

namespace sectile::test {

/// Of a prism with the corners 0, 1, 2 at one end and 3, 4, 5 at the other one: 0, 1 and 2 run
/// clockwise, as seen from outside.
inline constexpr std::array<std::array<std::uint32_t, 3>, 8> prism_triangles{
    {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}}};

}  // namespace sectile::test
