// Sets of numbers that several threads unite at once. Which come out does not depend on their
// order.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <numeric>

#include "numbers/unset_vector.h"

namespace sectile {

/// As DisjointSets. Only what is said to be so may go on beside other calls.
class ConcurrentSets {
 public:
  /// No number is in a set yet.
  explicit ConcurrentSets(std::size_t count) : parent_(count) {}

  std::size_t size() const { return parent_.size(); }

  /// Each number from `begin` up to, but without, `end` is a set of its own. Goes beside calls for
  /// other ranges; all numbers must have one before they are united.
  void separate(std::size_t begin, std::size_t end) {
    std::iota(parent_.begin() + static_cast<std::ptrdiff_t>(begin),
              parent_.begin() + static_cast<std::ptrdiff_t>(end),
              static_cast<std::uint32_t>(begin));
  }

  /// False if they were in one set. Goes beside other calls of it.
  bool unite(std::uint32_t i, std::uint32_t j) {
    for (;;) {
      i = climb(i);
      j = climb(j);
      if (i == j) return false;
      // What is the least of its set now may not be any more when it gets a parent.
      std::uint32_t least = std::max(i, j);
      if (std::atomic_ref(parent_[least])
              .compare_exchange_strong(least, std::min(i, j), std::memory_order_relaxed))
        return true;
    }
  }

  /// Is it the least of its set? Not beside unite().
  bool is_first(std::uint32_t i) const { return parent_[i] == i; }
  /// The least of the set. Not beside unite().
  std::uint32_t first(std::uint32_t i) const {
    while (parent_[i] != i) i = parent_[i];
    return i;
  }

 private:
  // Parents are less than their children, and ways to the least number only get shorter: what
  // another thread knows of them stays true.
  std::uint32_t climb(std::uint32_t i) {
    for (;;) {
      const std::uint32_t parent = load(i);
      if (parent == i) return i;
      const std::uint32_t next = load(parent);
      if (next != parent) std::atomic_ref(parent_[i]).store(next, std::memory_order_relaxed);
      i = parent;
    }
  }
  std::uint32_t load(std::uint32_t i) {
    return std::atomic_ref(parent_[i]).load(std::memory_order_relaxed);
  }

  UnsetVector<std::uint32_t> parent_;
};

}  // namespace sectile
