#include "primitives/circle.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace sectile {

namespace {

Vec2 in_first_octant(double degrees) {
  if (degrees == 45) return {std::sqrt(0.5), std::sqrt(0.5)};
  if (degrees == 30) return {std::sqrt(0.75), 0.5};
  const double radians = degrees * (std::numbers::pi / 180);
  return {std::cos(radians), std::sin(radians)};
}

// All differences here are exact (Sterbenz): an angle and its mirror image reach the same octant.
Vec2 in_first_quadrant(double degrees) {
  if (degrees <= 45) return in_first_octant(degrees);
  const Vec2 mirrored = in_first_octant(90 - degrees);
  return {mirrored.y, mirrored.x};
}

Vec2 in_upper_half(double degrees) {
  if (degrees <= 90) return in_first_quadrant(degrees);
  const Vec2 mirrored = in_first_quadrant(180 - degrees);
  return {0 - mirrored.x, mirrored.y};
}

}  // namespace

Vec2 unit_vector(double degrees) {
  const double turned = std::fmod(degrees, 360);
  const bool below = turned < 0;
  const double angle = std::fabs(turned);
  const Vec2 upper = in_upper_half(angle <= 180 ? angle : 360 - angle);
  return below != (angle > 180) ? Vec2{upper.x, 0 - upper.y} : upper;
}

Vec2 circle_point(std::uint64_t k, std::uint64_t n) {
  // The mirrors are taken in whole numbers; the one quotient is rounded correctly, so equal
  // fractions of a turn give equal points.
  k %= n;
  const bool below = 2 * k > n;
  if (below) k = n - k;
  const bool left = 4 * k > n;
  std::uint64_t numerator = left ? n - 2 * k : 2 * k;  // of a fraction of half a turn
  std::uint64_t denominator = n;
  const bool steep = 4 * numerator > denominator;
  if (steep) {
    numerator = denominator - 2 * numerator;
    denominator *= 2;
  }
  Vec2 p =
      in_first_octant(180.0 * static_cast<double>(numerator) / static_cast<double>(denominator));
  if (steep) std::swap(p.x, p.y);
  return {left ? 0 - p.x : p.x, below ? 0 - p.y : p.y};
}

}  // namespace sectile
