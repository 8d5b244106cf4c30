#include "selftest/wedge_order.h"

#include <algorithm>
#include <numeric>

#include "geometry/around_line.h"

namespace sectile {
namespace {

LineSide in_line(const SideOfLine& s) {
  return {s.plane, s.forward};
}

}  // namespace

bool sort_around(const Kernel& kernel, int axis, std::span<SideOfLine> sides) {
  const AroundLine around(kernel, axis, Sign::positive);
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

std::vector<std::uint32_t> places_around(const Kernel& kernel, int axis,
                                         std::span<const SideOfLine> sides) {
  if (sides.empty()) return {};
  const AroundLine around(kernel, axis, Sign::positive);
  const LineSide start = in_line(sides[0]);
  std::vector<std::uint32_t> order(sides.size()), places(sides.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return around.before(start, in_line(sides[i]), in_line(sides[j]), i < j);
  });
  for (std::size_t i = 1; i < order.size(); ++i)
    places[order[i]] =
        places[order[i - 1]] +
        (around.tied(in_line(sides[order[i - 1]]), in_line(sides[order[i]])) ? 0 : 1);
  return places;
}

}  // namespace sectile
