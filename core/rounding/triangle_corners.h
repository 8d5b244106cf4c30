// The corners of a triangle, which go around it: 0, 1, 2.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace sectile {

inline std::size_t next_corner(std::size_t k) {
  return k < 2 ? k + 1 : 0;
}

inline std::size_t previous_corner(std::size_t k) {
  return k > 0 ? k - 1 : 2;
}

inline bool has_corner(const std::array<std::uint32_t, 3>& corners, std::uint32_t vertex) {
  return corners[0] == vertex || corners[1] == vertex || corners[2] == vertex;
}

/// The corner that is at a vertex of the triangle.
inline std::size_t corner_at(const std::array<std::uint32_t, 3>& corners, std::uint32_t vertex) {
  return corners[0] == vertex ? 0 : corners[1] == vertex ? 1 : 2;
}

}  // namespace sectile
