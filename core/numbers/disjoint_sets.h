// Sets of numbers that grow together (union by the least member, with path halving).
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace sectile {

class DisjointSets {
 public:
  /// Each number below `count` is a set of its own.
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  std::size_t size() const { return parent_.size(); }
  /// The least of the set.
  std::uint32_t first(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(std::uint32_t i, std::uint32_t j) {
    i = first(i);
    j = first(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }

  struct Numbered {
    std::vector<std::uint32_t> of;  ///< per number: which set it is in
    std::uint32_t count = 0;
  };
  /// The sets, in the order of their first members.
  Numbered numbered() && {
    Numbered sets;
    // No parent comes after its children.
    for (std::uint32_t i = 0; i < parent_.size(); ++i)
      parent_[i] = parent_[i] == i ? sets.count++ : parent_[parent_[i]];
    sets.of = std::move(parent_);
    return sets;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace sectile
