#include "selftest/wedge_order.h"

#include <algorithm>

#include "geometry/around_line.h"

namespace sectile {

bool sort_around(const Kernel& kernel, int axis, std::span<SideOfLine> sides) {
  const AroundLine around(kernel, axis, Sign::positive);
  const auto in_line = [](const SideOfLine& s) { return LineSide{s.plane, s.forward}; };
  const LineSide start = in_line(sides[0]);
  std::sort(sides.begin() + 1, sides.end(), [&](const SideOfLine& a, const SideOfLine& b) {
    return around.before(start, in_line(a), in_line(b), a.number < b.number);
  });
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const SideOfLine &a = sides[i], &b = sides[i + 1 < sides.size() ? i + 1 : 0];
    if (a.forward == b.forward || around.tied(in_line(a), in_line(b))) return false;
  }
  return true;
}

}  // namespace sectile
