// Groups of neighbours along a curve that fills space.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace sectile {

/// Cuts keys (see curve_order.h) into groups of about `most` at the most, and adds the end of each
/// to `ends`, counted from `first`. Where there is a choice, a group is a cube of the curve's grid
/// or several in one larger cube: a surface in it hangs together more than along any piece of the
/// curve. One of less than `least` joins a neighbour that has room: up to most + 2 least.
void add_groups_along_curve(std::span<const std::uint64_t> keys, std::size_t least,
                            std::size_t most, std::uint32_t first,
                            std::vector<std::uint32_t>& ends);

}  // namespace sectile
