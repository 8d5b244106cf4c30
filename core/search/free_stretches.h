// Stretches of a line, numbered along it, of which each is taken once.
#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

namespace sectile {

class FreeStretches {
 public:
  explicit FreeStretches(std::size_t count) : next_(count + 1) { free_all(); }

  void free_all() { std::iota(next_.begin(), next_.end(), 0u); }
  /// Calls visit(stretch) for those from `low` up to, but without, `high` that are still free, and
  /// takes them. As fast as if those that were taken before were not there.
  template <class Visit>
  void take(std::uint32_t low, std::uint32_t high, const Visit& visit) {
    for (std::uint32_t s = first_free(low); s < high; s = first_free(s)) {
      visit(s);
      next_[s] = s + 1;
    }
  }

 private:
  std::uint32_t first_free(std::uint32_t s) {
    while (next_[s] != s) s = next_[s] = next_[next_[s]];
    return s;
  }

  std::vector<std::uint32_t> next_;  // itself, if it is free; the end always is
};

}  // namespace sectile
