// Tables of what is in one chunk of a mesh of triangles, small enough to stay in the fastest
// memory.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "import/triangles/triangle_mesh.h"

namespace sectile {

/// The points of a chunk with their numbers.
class PointNumbers {
 public:
  void clear() { slots_.fill(empty); }
  /// The number of a point, which becomes `next` if it is new.
  std::uint16_t find_or_add(std::uint32_t point, std::uint16_t next) {
    std::size_t i = point * 0x9E3779B1u >> (32 - bits);
    std::uint64_t met = slots_[i];
    // No branch tells new points from known ones: it would be guessed wrong too often.
    while (unsigned(met != empty) & unsigned(met >> 16 != point)) {
      i = (i + 1) % slots_.size();
      met = slots_[i];
    }
    const std::uint64_t if_new = 0 - std::uint64_t(met == empty);
    met ^= (met ^ (std::uint64_t(point) << 16 | next)) & if_new;
    slots_[i] = met;
    return static_cast<std::uint16_t>(met);
  }

 private:
  static constexpr int bits = 10;
  static constexpr std::uint64_t empty = ~std::uint64_t(0);
  static_assert(3 * TriangleMesh::most_of_a_chunk < 1u << bits);
  // A point, and its number in the lower 16 bits.
  std::array<std::uint64_t, std::size_t(1) << bits> slots_;
};

/// The half-edges of a chunk by the lines on which they lie, between vertices of the chunk.
class ChunkLines {
 public:
  static constexpr std::uint16_t none = 1023, full = 1022;

  void clear() { slots_.fill(none); }
  /// The half-edge that waits on the line of this one. If there is `none`, this one waits from now
  /// on; where two have met, the line is `full`.
  std::uint16_t meet(std::uint16_t half_edge, std::uint32_t from, std::uint32_t to) {
    const std::uint32_t line = 1u << 31 | std::min(from, to) << 20 | std::max(from, to) << 10;
    std::size_t i = line * 0x9E3779B1u >> (32 - bits);
    std::uint32_t met = slots_[i];
    // Without a branch that tells new lines from known ones: every second would be guessed wrong.
    while (unsigned(met != none) & unsigned((met ^ line) > none)) {
      i = (i + 1) % slots_.size();
      met = slots_[i];
    }
    const std::uint32_t if_new = 0u - std::uint32_t(met == none);
    slots_[i] = line | (full ^ ((full ^ half_edge) & if_new));
    return static_cast<std::uint16_t>(met & none);
  }

 private:
  static constexpr int bits = 10;
  static_assert(3 * TriangleMesh::most_of_a_chunk < full);
  // A line in the upper bits, which half-edge waits on it in the lower ten; `none` without a line.
  std::array<std::uint32_t, std::size_t(1) << bits> slots_;
};

}  // namespace sectile
