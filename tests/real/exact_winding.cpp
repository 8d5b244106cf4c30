#include "real/exact_winding.h"

#include <algorithm>
#include <cmath>

#include "unit/rational.h"

namespace sectile::test {
namespace {

using Real = long double;

// Differences of doubles and products of them have 64 bits here; these bounds are far greater than
// what is lost.
constexpr Real relative = 0x1p-58L, least = 0x1p-16000L;

int sign(const Rational& value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

// Twice the area of (a, b, p), seen against x.
int turn(const Vec3& a, const Vec3& b, const Vec3& p) {
  const Real u = (Real(b.y) - a.y) * (Real(p.z) - a.z), v = (Real(b.z) - a.z) * (Real(p.y) - a.y);
  if (std::abs(u - v) > (std::abs(u) + std::abs(v)) * relative + least) return u > v ? 1 : -1;
  const Rational y = rational(a.y), z = rational(a.z);
  return sign((rational(b.y) - y) * (rational(p.z) - z) -
              (rational(b.z) - z) * (rational(p.y) - y));
}

template <class Number, class Read>
Number volume_of(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p, const Read& read,
                 Number* size) {
  const Vec3* points[] = {&b, &c, &p};
  Number v[3][3];
  for (int i = 0; i < 3; ++i) {
    v[i][0] = read(points[i]->x) - read(a.x);
    v[i][1] = read(points[i]->y) - read(a.y);
    v[i][2] = read(points[i]->z) - read(a.z);
  }
  Number sum = 0;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const Number left = v[0][i] * v[1][j], right = v[0][j] * v[1][i];
    sum += v[2][k] * (left - right);
    if (size) *size += abs(v[2][k]) * (abs(left) + abs(right));
  }
  return sum;
}

// 1: p is where the normal of (a, b, c) points to.
int side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  using std::abs;
  Real size = 0;
  const Real sum = volume_of<Real>(
      a, b, c, p, [](double x) { return Real(x); }, &size);
  if (std::abs(sum) > size * relative + least) return sum > 0 ? 1 : -1;
  return sign(volume_of<Rational>(
      a, b, c, p, [](double x) { return rational(x); }, nullptr));
}

// Does the ray's line, an infinitesimal way up in y and farther up in z by less, cross the edge's
// shadow above the point? 1 or -1 by the edge's direction.
int crossing(const Vec3& a, const Vec3& b, const Vec3& p) {
  if ((a.y > p.y) == (b.y > p.y)) return 0;
  const int up = b.y > p.y ? 1 : -1;
  // In z the shadow is at the point or below it, where it counts as below.
  return turn(a, b, p) * up < 0 ? up : 0;
}

}  // namespace

ExactWinding::ExactWinding(const PolygonMesh& mesh) {
  std::size_t first = 0;
  for (const std::uint32_t size : mesh.face_sizes) {
    const auto at = [&](std::size_t k) { return mesh.positions[mesh.indices[first + k]]; };
    for (std::size_t k = 1; k + 1 < size; ++k) triangles_.push_back({at(0), at(k), at(k + 1)});
    first += size;
  }
}

std::optional<int> ExactWinding::operator()(const Vec3& p) const {
  int winding = 0;
  for (const auto& [a, b, c] : triangles_) {
    const bool above = a.y > p.y;
    if ((above == (b.y > p.y) && above == (c.y > p.y)) || std::max({a.x, b.x, c.x}) < p.x) continue;
    const int around = crossing(a, b, p) + crossing(b, c, p) + crossing(c, a, p);
    if (around == 0) continue;
    const int s = side(a, b, c, p);
    if (s == 0) return {};
    // Seen against x, the shadow of a face that looks towards the ray's end is clockwise.
    const int looks = -around;
    if (s * looks < 0) winding += looks;
  }
  return winding;
}

}  // namespace sectile::test
