// Numbers that a loop is run for, and how finely they may be cut.
#pragma once

#include <cstddef>
#include <type_traits>

namespace sectile::parallel {

/// From begin() up to, but without, end(). Parts have more than half a grain, where there are as
/// many.
template <class Number>
class Range {
 public:
  Range(std::type_identity_t<Number> begin, Number end, std::size_t grain = 1)
      : begin_(begin), end_(end), grain_(grain) {}

  Number begin() const { return begin_; }
  Number end() const { return end_; }
  std::size_t grain() const { return grain_; }
  bool empty() const { return !(begin_ < end_); }

 private:
  Number begin_, end_;
  std::size_t grain_;
};

}  // namespace sectile::parallel
