// The vertices of a boundary in blocks.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "numbers/disjoint_sets.h"
#include "storage/solid_data.h"

namespace sectile {

/// Numbers for what the blocks have, one slot after another.
struct NumbersOfSlots {
  std::vector<std::uint32_t> first;  ///< per slot
  std::uint32_t count = 0;

  template <class Count>
  NumbersOfSlots(std::span<const Slot> slots, const Count& count_of) {
    for (const Slot& slot : slots) {
      first.push_back(count);
      if (!slot.empty()) count += static_cast<std::uint32_t>(count_of(*slot.block));
    }
  }
};

/// Counts how many sets are left when some are united.
class CountedSets {
 public:
  explicit CountedSets(std::size_t count) : sets_(count), count_(count) {}
  void unite(std::uint32_t i, std::uint32_t j);
  std::uint32_t first(std::uint32_t i) { return sets_.first(i); }
  std::size_t count() const { return count_; }

 private:
  DisjointSets sets_;
  std::size_t count_;
};

/// The blocks' own vertices, numbered, in one set if they are one vertex of the boundary: blocks
/// have the ends of the edges between them in common.
struct VertexSets {
  explicit VertexSets(const SolidData& solid);

  NumbersOfSlots number;
  CountedSets sets;
};

}  // namespace sectile
