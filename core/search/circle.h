// Positions around a line.
#pragma once

#include <cstdint>
#include <iterator>
#include <set>

namespace sectile {

class Circle {
 public:
  bool empty() const { return at_.empty(); }
  void add(std::uint32_t position) { at_.insert(position); }
  void remove(std::uint32_t position) { at_.erase(position); }

  /// The last one before a position, or the first one behind it, around the line; of one that is in
  /// the circle, its neighbours. It must not be empty.
  std::uint32_t before(std::uint32_t position) const {
    const auto at = at_.lower_bound(position);
    return at == at_.begin() ? *at_.rbegin() : *std::prev(at);
  }
  std::uint32_t behind(std::uint32_t position) const {
    const auto at = at_.upper_bound(position);
    return at == at_.end() ? *at_.begin() : *at;
  }
  /// Calls visit(position) for those from one position up to, but without, another one.
  template <class Visit>
  void for_each_in(std::uint32_t from, std::uint32_t to, const Visit& visit) const {
    for (auto at = at_.lower_bound(from); at != at_.end() && *at < to; ++at) visit(*at);
  }

 private:
  std::set<std::uint32_t> at_;
};

}  // namespace sectile
