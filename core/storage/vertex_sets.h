// The vertices of a boundary in blocks.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "numbers/concurrent_sets.h"
#include "storage/solid_data.h"

namespace sectile {

/// Numbers for what the blocks have, one slot after another.
struct NumbersOfSlots {
  std::vector<std::uint32_t> first;  ///< per slot, and the end
  std::uint32_t count = 0;

  template <class Count>
  NumbersOfSlots(std::span<const Slot> slots, const Count& count_of) {
    first.reserve(slots.size() + 1);
    for (const Slot& slot : slots) {
      first.push_back(count);
      if (!slot.empty()) count += static_cast<std::uint32_t>(count_of(*slot.block));
    }
    first.push_back(count);
  }

  /// Each a set of its own.
  ConcurrentSets separate() const;
};

/// The blocks' own vertices, numbered, in one set if they are one vertex of the boundary: blocks
/// have the ends of the edges between them in common.
struct VertexSets {
  explicit VertexSets(const SolidData& solid);

  NumbersOfSlots number;
  ConcurrentSets sets;
  std::size_t count = 0;  ///< of sets
};

}  // namespace sectile
