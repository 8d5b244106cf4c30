#include "selftest/wedge_order.h"

#include <algorithm>

namespace sectile {
namespace {

class AroundLine {
 public:
  AroundLine(const Kernel& kernel, int axis) : kernel_(kernel), axis_(axis) {}

  Sign turn(const SideOfLine& a, const SideOfLine& b) const {
    const Sign s = kernel_.cross(a.plane, b.plane, axis_);
    return a.forward == b.forward ? s : -s;
  }
  bool same_way(const SideOfLine& a, const SideOfLine& b) const {
    return kernel_.same_direction(a.plane, b.plane) == (a.forward == b.forward);
  }
  bool tied(const SideOfLine& a, const SideOfLine& b) const {
    return turn(a, b) == Sign::zero && same_way(a, b);
  }
  /// Counter-clockwise from `start`: 0 for its own direction, 1 and 3 for what is before and after
  /// the opposite one.
  int quarter(const SideOfLine& start, const SideOfLine& side) const {
    const Sign s = turn(start, side);
    if (s == Sign::zero) return same_way(start, side) ? 0 : 2;
    return s == Sign::positive ? 1 : 3;
  }

 private:
  const Kernel& kernel_;
  int axis_;
};

}  // namespace

bool sort_around(const Kernel& kernel, int axis, std::span<SideOfLine> sides) {
  const AroundLine around(kernel, axis);
  const SideOfLine start = sides[0];
  std::sort(sides.begin() + 1, sides.end(), [&](const SideOfLine& a, const SideOfLine& b) {
    const int in_a = around.quarter(start, a), in_b = around.quarter(start, b);
    if (in_a != in_b) return in_a < in_b;
    const Sign s = around.turn(a, b);
    return s != Sign::zero ? s == Sign::positive : a.number < b.number;
  });
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const SideOfLine &a = sides[i], &b = sides[i + 1 < sides.size() ? i + 1 : 0];
    if (a.forward == b.forward || around.tied(a, b)) return false;
  }
  return true;
}

}  // namespace sectile
