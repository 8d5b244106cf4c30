// An order along a curve that fills space.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "parallel/parallel.h"
#include "search/hilbert.h"
#include "search/radix_sort.h"

namespace sectile {

/// Per element its place on the curve through `all`, in the upper half, and its number, in the
/// order of the curve. Elements have places (Vec3) or boxes, which count as their centres. Of those
/// in one cell of the curve's grid, lower numbers come first; empty boxes are in the first cell.
template <class PlaceOf>
std::vector<std::uint64_t> keys_along_curve(std::size_t count, const Box& all,
                                            const PlaceOf& place_of) {
  const HilbertCurve curve(all);
  std::vector<std::uint64_t> keys(count);
  parallel::loop(parallel::Range<std::size_t>(0, count, 4096), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i)
      keys[i] = std::uint64_t(curve(place_of(i))) << 32 | i;
  });
  sort_by_upper_half(keys, HilbertCurve::bits);
  return keys;
}

/// The numbers 0 … count - 1 in the order of the curve.
inline std::vector<std::uint32_t> numbers_of(const std::vector<std::uint64_t>& keys) {
  std::vector<std::uint32_t> order(keys.size());
  parallel::loop(parallel::Range<std::size_t>(0, keys.size(), 4096), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i)
      order[i] = static_cast<std::uint32_t>(keys[i]);
  });
  return order;
}

/// The numbers of boxes in the order of the curve through all of them.
inline std::vector<std::uint32_t> order_along_curve(const std::vector<Box>& boxes) {
  Box all;
  for (const Box& box : boxes) all.add(box);
  return numbers_of(
      keys_along_curve(boxes.size(), all, [&](std::size_t i) -> const Box& { return boxes[i]; }));
}

}  // namespace sectile
