#include "geometry/four_points.h"

#include <cmath>

#include "geometry/formulas.h"
#include "numbers/bounded.h"
#include "numbers/dyadic.h"

namespace sectile {
namespace {

template <class Number>
Number volume_of(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  Number edges[3][3];
  const Vec3* const others[] = {&a, &b, &c};
  for (std::size_t i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      edges[i][k] = Number::difference(component(*others[i], k), component(d, k));
  return determinant(edges[0], edges[1], edges[2]);
}

}  // namespace

// Seen from d, the volume is negative where the points turn left.
Sign side_of_three(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  if (const Sign clear = clear_side(a, b, c, d); clear != Sign::zero) return clear;
  if (const Bounded near = volume_of<Bounded>(a, b, c, d); near.decided()) return -near.sign();
  return -volume_of<Dyadic>(a, b, c, d).sign();
}

bool in_one_plane(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return side_of_three(a, b, c, d) == Sign::zero;
}

double six_times_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return std::abs(volume_of<Dyadic>(a, b, c, d).nearest());
}

}  // namespace sectile
