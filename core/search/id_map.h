// A map from 32-bit ids to 32-bit ids, for loading parts of a solid: a table where there are few
// ids or many of them will be asked for, otherwise a small open-addressing map.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

namespace sectile {

class IdMap {
 public:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;

  /// `ids`: all are less than this.
  explicit IdMap(std::size_t expected, std::size_t ids = none) {
    if (ids <= few_ids || ids / table_share <= expected) {
      table_.assign(ids, none);
      return;
    }
    std::size_t size = 16;
    while (size < 2 * expected) size *= 2;
    slots_.assign(size, {none, none});
    shift_ = 32 - std::bit_width(size - 1);
  }

  /// The value for a key, to be set if it is none. Valid until the next call.
  std::uint32_t& operator[](std::uint32_t key) {
    if (slots_.empty()) return table_[key];
    if (2 * (used_ + 1) > slots_.size()) grow();
    Slot& slot = find(key);
    if (slot.key == none) {
      slot.key = key;
      ++used_;
    }
    return slot.value;
  }

  /// The value for a key, or none.
  std::uint32_t known(std::uint32_t key) const {
    return slots_.empty() ? table_[key] : slots_[place(key)].value;
  }

 private:
  static constexpr std::size_t few_ids = 4096;
  // Neighbours in a table are neighbours in memory, in a map they are not: to fill a line of memory
  // takes less time than to fetch one.
  static constexpr std::size_t table_share = 16;
  struct Slot {
    std::uint32_t key, value;
  };
  std::size_t place(std::uint32_t key) const {
    // The upper bits: the lower ones are alike for all keys that are alike in theirs.
    std::size_t i = (key * 0x9E3779B1u) >> shift_;
    while (slots_[i].key != none && slots_[i].key != key) i = (i + 1) & (slots_.size() - 1);
    return i;
  }
  Slot& find(std::uint32_t key) { return slots_[place(key)]; }
  void grow() {
    std::vector<Slot> old(2 * slots_.size(), Slot{none, none});
    old.swap(slots_);
    --shift_;
    for (const Slot& slot : old)
      if (slot.key != none) find(slot.key) = slot;
  }

  std::vector<std::uint32_t> table_;
  std::vector<Slot> slots_;  // empty if there is a table
  std::size_t used_ = 0;
  int shift_ = 0;
};

}  // namespace sectile
