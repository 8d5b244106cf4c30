// Sorting numbers digit by digit: for many, faster than by comparing them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sectile {

/// Sorts keys by their upper 32 bits, of which the lower `bits` are used; equal ones stay as they
/// are. If the lower halves ascend, that is the order of the keys.
inline void sort_by_upper_half(std::vector<std::uint64_t>& keys, unsigned bits) {
  constexpr unsigned digit = 10, buckets = 1u << digit;
  if (keys.size() < 2 * buckets) {
    std::stable_sort(keys.begin(), keys.end(),
                     [](std::uint64_t a, std::uint64_t b) { return a >> 32 < b >> 32; });
    return;
  }
  std::vector<std::uint64_t> other(keys.size());
  for (unsigned shift = 32; shift < 32 + bits; shift += digit) {
    std::array<std::uint32_t, buckets> at{};
    for (const std::uint64_t key : keys) ++at[(key >> shift) % buckets];
    std::uint32_t end = 0;
    for (std::uint32_t& n : at) {
      const std::uint32_t count = n;
      n = end;
      end += count;
    }
    for (const std::uint64_t key : keys) other[at[(key >> shift) % buckets]++] = key;
    keys.swap(other);
  }
}

}  // namespace sectile
