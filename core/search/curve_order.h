// An order along a curve that fills space.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "parallel/parallel.h"
#include "search/morton.h"
#include "search/radix_sort.h"

namespace sectile {

/// The numbers 0 … count - 1, in the order of their places (Vec3), or of the centres of their
/// boxes, along the curve through `all`. Of those in one cell of its grid, lower numbers come
/// first; empty boxes are in the first cell.
template <class PlaceOf>
std::vector<std::uint32_t> order_along_curve(std::size_t count, const Box& all,
                                             const PlaceOf& place_of) {
  const Morton morton(all);
  std::vector<std::uint64_t> keys(count);
  const tbb::blocked_range<std::size_t> numbers(0, count, 4096);
  parallel::loop(numbers, [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i)
      keys[i] = std::uint64_t(morton(place_of(i))) << 32 | i;
  });
  sort_by_upper_half(keys, Morton::bits);
  std::vector<std::uint32_t> order(count);
  parallel::loop(numbers, [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i)
      order[i] = static_cast<std::uint32_t>(keys[i]);
  });
  return order;
}

}  // namespace sectile
