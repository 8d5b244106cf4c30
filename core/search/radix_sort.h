// Sorting numbers digit by digit: for many, faster than by comparing them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "parallel/parallel.h"

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
  // Each part counts, and then moves, its own keys.
  const std::size_t parts = std::clamp<std::size_t>(keys.size() >> 15, 1, 16);
  std::vector<std::array<std::uint32_t, buckets>> at(parts);
  std::vector<std::uint64_t> other(keys.size());
  const auto for_each_key = [&](std::size_t part, unsigned shift, const auto& visit) {
    const std::size_t end = keys.size() * (part + 1) / parts;
    for (std::size_t i = keys.size() * part / parts; i < end; ++i)
      visit(keys[i], at[part][(keys[i] >> shift) % buckets]);
  };
  for (unsigned shift = 32; shift < 32 + bits; shift += digit) {
    parallel::loop(0, parts, [&](std::size_t p) {
      at[p].fill(0);
      for_each_key(p, shift, [](std::uint64_t, std::uint32_t& count) { ++count; });
    });
    std::uint32_t end = 0;
    for (unsigned bucket = 0; bucket < buckets; ++bucket)
      for (auto& of_part : at) end += std::exchange(of_part[bucket], end);
    parallel::loop(0, parts, [&](std::size_t p) {
      for_each_key(p, shift,
                   [&](std::uint64_t key, std::uint32_t& place) { other[place++] = key; });
    });
    keys.swap(other);
  }
}

}  // namespace sectile
