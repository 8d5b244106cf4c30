#include "geometry/plane_value.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>

#include "geometry/axes.h"
#include "geometry/formulas.h"
#include "numbers/dyadic.h"
#include "numbers/rounding.h"

namespace sectile {
namespace {

// Bounds are for counted roundings, rounded up amply.
using rounding::underflow;
using rounding::unit;

// Exact if all coordinates are multiples of one unit and below 2^16 of it: then differences have 17
// bits, normals 35, and offsets 53.
class BitRange {
 public:
  void add(double value) {
    if (value == 0) return;
    int exponent;
    const double mantissa = std::frexp(value, &exponent);
    const auto bits = static_cast<std::uint64_t>(std::abs(mantissa) * 0x1p53);
    high_ = std::max(high_, exponent);
    low_ = std::min(low_, exponent - 53 + __builtin_ctzll(bits));
  }
  bool small() const { return high_ < low_ || (high_ - low_ <= 16 && low_ > -60 && high_ < 60); }

 private:
  int low_ = std::numeric_limits<int>::max(), high_ = std::numeric_limits<int>::min();
};

// Planes parallel to a coordinate plane have the shortest coefficients: ±1 and ∓the coordinate.
bool axis_parallel(const Vec3& a, const Vec3& b, const Vec3& c, PlaneValue& value) {
  for (int axis = 0; axis < 3; ++axis) {
    const double at = component(a, axis);
    if (component(b, axis) != at || component(c, axis) != at) continue;
    if (at != 0 && (std::abs(at) < 0x1p-200 || std::abs(at) > 0x1p200)) return false;
    const int i = next_axis(axis), j = next_next_axis(axis);
    const double left = (component(b, i) - component(a, i)) * (component(c, j) - component(a, j));
    const double right = (component(b, j) - component(a, j)) * (component(c, i) - component(a, i));
    const double error = 8 * unit * (std::abs(left) + std::abs(right)) + 4 * underflow;
    const Sign sign = std::abs(left - right) > error ? sign_of(left - right)
                                                     : turn_of<Dyadic>(a, b, c, axis).sign();
    if (sign == Sign::zero) return false;
    value = {{0, 0, 0}, sign == Sign::positive ? -at : at, 0, 0, true, std::int8_t(axis)};
    value.n[axis] = sign == Sign::positive ? 1 : -1;
    return true;
  }
  return false;
}

// Three points or fewer whose positions are exact, or off by half an ulp each.
struct Points {
  const Vec3& a;
  const Vec3& b;
  const Vec3& c;
  bool exact;

  // How far the difference of two of them may be off on one axis.
  double slack(int axis) const {
    if (exact) return 0;
    const double sum =
        std::abs(component(a, axis)) + std::abs(component(b, axis)) + std::abs(component(c, axis));
    return 4 * unit * sum + 4 * underflow;
  }
};

PlaneValue with_offset(PlaneValue value, const Points& points) {
  const Vec3& a = points.a;
  const double x = value.n[0] * a.x, y = value.n[1] * a.y, z = value.n[2] * a.z;
  value.d = -(x + y + z);
  const double size = std::abs(a.x) + std::abs(a.y) + std::abs(a.z) + 4 * underflow;
  value.d_error = value.n_error * size * (1 + 8 * unit) +
                  8 * unit * (std::abs(x) + std::abs(y) + std::abs(z)) + 8 * underflow;
  if (!points.exact)
    value.d_error +=
        underflow * (std::abs(value.n[0]) + std::abs(value.n[1]) + std::abs(value.n[2]));
  return value;
}

PlaneValue exact_if_short(PlaneValue value, std::initializer_list<Vec3> points) {
  BitRange bits;
  for (const Vec3& p : points)
    for (const double coordinate : {p.x, p.y, p.z}) {
      bits.add(coordinate);
      if (!bits.small()) return value;
    }
  value.n_error = value.d_error = 0;
  value.exact = true;
  return value;
}

// The error of a normal u × v beside rounding, if u and v are off by du and dv.
double cross_slack(const double (&u)[3], const double (&v)[3], const double (&du)[3],
                   const double (&dv)[3]) {
  double most = 0;
  for (int k = 0; k < 3; ++k) {
    const int i = next_axis(k), j = next_next_axis(k);
    const double sum = du[i] * std::abs(v[j]) + std::abs(u[i]) * dv[j] + du[i] * dv[j] +
                       du[j] * std::abs(v[i]) + std::abs(u[j]) * dv[i] + du[j] * dv[i];
    // Not std::max, which may drop what is no number.
    if (!(sum <= most)) most = sum;
  }
  return most * (1 + 8 * unit) + 8 * underflow;
}

void cross_product(const double (&u)[3], const double (&v)[3], PlaneValue& value) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const int i = next_axis(k), j = next_next_axis(k);
    const double left = u[i] * v[j], right = u[j] * v[i];
    value.n[k] = left - right;
    sum = std::max(sum, std::abs(left) + std::abs(right));
  }
  value.n_error = 8 * unit * sum + 4 * underflow;
}

PlaneValue through_points(const Points& points) {
  const auto& [a, b, c, exact] = points;
  PlaneValue value{};
  if (exact && axis_parallel(a, b, c, value)) return value;
  const double u[3] = {b.x - a.x, b.y - a.y, b.z - a.z};
  const double v[3] = {c.x - a.x, c.y - a.y, c.z - a.z};
  cross_product(u, v, value);
  if (exact) return exact_if_short(with_offset(value, points), {a, b, c});
  const double slack[3] = {points.slack(0), points.slack(1), points.slack(2)};
  value.n_error += cross_slack(u, v, slack, slack);
  return with_offset(value, points);
}

PlaneValue along_axis(const Points& points, int axis) {
  const Vec3 &a = points.a, &b = points.b;
  const double u[3] = {b.x - a.x, b.y - a.y, b.z - a.z};
  PlaneValue value{};
  const int i = next_axis(axis), j = next_next_axis(axis);
  // u × e_axis
  value.n[i] = u[j];
  value.n[j] = -u[i];
  value.n_error =
      2 * unit * (std::abs(u[i]) + std::abs(u[j])) + underflow + points.slack(i) + points.slack(j);
  value = with_offset(value, points);
  return points.exact ? exact_if_short(value, {a, b}) : value;
}

PlaneValue along_direction(const Points& points, const ExactDirection& along) {
  const Vec3 &a = points.a, &b = points.b;
  const double u[3] = {b.x - a.x, b.y - a.y, b.z - a.z};
  double v[3], dv[3];
  for (int k = 0; k < 3; ++k) {
    v[k] = along.d[k].exact().nearest();
    dv[k] = unit * std::abs(v[k]) + underflow;
  }
  PlaneValue value{};
  cross_product(u, v, value);
  value.n_error += cross_slack(u, v, {points.slack(0), points.slack(1), points.slack(2)}, dv);
  return with_offset(value, points);
}

PlaneValue with_coefficients(const PlaneCoefficients& k) {
  const double largest = std::max({std::abs(k.a), std::abs(k.b), std::abs(k.c), std::abs(k.d)});
  double least = largest;
  for (const double value : {k.a, k.b, k.c, k.d})
    if (value != 0) least = std::min(least, std::abs(value));
  return {{k.a, k.b, k.c}, k.d, 0, 0, largest < 0x1p200 && least > 0x1p-200};
}

PlaneValue with_coefficients(const ExactCoefficients& k) {
  PlaneValue value{};
  double largest = 0;
  for (int i = 0; i < 3; ++i) {
    value.n[i] = k.n[i].exact().nearest();
    largest = std::max(largest, std::abs(value.n[i]));
  }
  value.d = k.d.exact().nearest();
  value.n_error = unit * largest + underflow;
  value.d_error = unit * std::abs(value.d) + underflow;
  return value;
}

}  // namespace

PlaneValue plane_value(const Geometry& g, PlaneId plane) {
  using Kind = PlaneDefinition::Kind;
  const PlaneDefinition& s = g.definition(plane);
  if (s.kind() == Kind::coefficients) return with_coefficients(g.coefficients[s.a]);
  if (s.kind() == Kind::exact_coefficients) return with_coefficients(*g.exact_coefficients[s.a]);
  const PointId a(s.a), b(s.b), c(s.kind() == Kind::three_points ? s.c : s.a);
  const bool exact = !g.is_moved(a) && !g.is_moved(b) && !g.is_moved(c);
  const Points points{g.position(a), g.position(b), g.position(c), exact};
  switch (s.kind()) {
    case Kind::three_points:
      return through_points(points);
    case Kind::along_direction:
      return along_direction(points, *g.directions[s.direction()]);
    default:
      return along_axis(points, axis_of(s.kind()));
  }
}

}  // namespace sectile
