#include "geometry/kernel.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sectile {
namespace {

// Half an ulp, the smallest positive double, and bounds for counted roundings (rounded up amply).
constexpr double unit = 0x1p-53;
constexpr double smallest = std::numeric_limits<double>::denorm_min();

constexpr int next_axis(int axis) {
  return axis == 2 ? 0 : axis + 1;
}
constexpr int next_next_axis(int axis) {
  return axis == 0 ? 2 : axis - 1;
}

double component(const Vec3& v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}
const Dyadic& component(const ExactPoint& p, int axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

struct ExactVec {
  Dyadic x, y, z;
};

ExactVec exact_vec(const Vec3& p) {
  return {Dyadic(p.x), Dyadic(p.y), Dyadic(p.z)};
}
ExactVec operator-(const ExactVec& a, const ExactVec& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Dyadic minor(const Dyadic& a, const Dyadic& b, const Dyadic& c, const Dyadic& d) {
  return a * d - b * c;
}

int axis_of(PlaneDefinition::Kind kind) {
  return static_cast<int>(kind) - static_cast<int>(PlaneDefinition::Kind::along_x);
}

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
  void add(const Vec3& p) {
    add(p.x);
    add(p.y);
    add(p.z);
  }
  bool small() const { return high_ < low_ || (high_ - low_ <= 16 && low_ > -60 && high_ < 60); }

 private:
  int low_ = std::numeric_limits<int>::max(), high_ = std::numeric_limits<int>::min();
};

Sign exact_turn(const Vec3& p, const Vec3& q, const Vec3& r, int axis) {
  const int i = next_axis(axis), j = next_next_axis(axis);
  const Dyadic qi = Dyadic(component(q, i)) - Dyadic(component(p, i));
  const Dyadic qj = Dyadic(component(q, j)) - Dyadic(component(p, j));
  const Dyadic ri = Dyadic(component(r, i)) - Dyadic(component(p, i));
  const Dyadic rj = Dyadic(component(r, j)) - Dyadic(component(p, j));
  return (qi * rj - qj * ri).sign();
}

// Planes parallel to a coordinate plane have the shortest coefficients: ±1 and ∓the coordinate.
bool axis_parallel(const Vec3& a, const Vec3& b, const Vec3& c, PlaneValue& value) {
  for (int axis = 0; axis < 3; ++axis) {
    const double at = component(a, axis);
    if (component(b, axis) != at || component(c, axis) != at) continue;
    if (at != 0 && (std::abs(at) < 0x1p-200 || std::abs(at) > 0x1p200)) return false;
    const int i = next_axis(axis), j = next_next_axis(axis);
    const double left = (component(b, i) - component(a, i)) * (component(c, j) - component(a, j));
    const double right = (component(b, j) - component(a, j)) * (component(c, i) - component(a, i));
    const double error = 8 * unit * (std::abs(left) + std::abs(right)) + 4 * smallest;
    const Sign sign =
        std::abs(left - right) > error ? sign_of(left - right) : exact_turn(a, b, c, axis);
    if (sign == Sign::zero) return false;
    value = {{0, 0, 0}, sign == Sign::positive ? -at : at, 0, 0, true};
    value.n[axis] = sign == Sign::positive ? 1 : -1;
    return true;
  }
  return false;
}

PlaneValue with_offset(PlaneValue value, const Vec3& a) {
  const double x = value.n[0] * a.x, y = value.n[1] * a.y, z = value.n[2] * a.z;
  value.d = -(x + y + z);
  value.d_error = value.n_error * (std::abs(a.x) + std::abs(a.y) + std::abs(a.z)) * (1 + 8 * unit) +
                  8 * unit * (std::abs(x) + std::abs(y) + std::abs(z)) + 8 * smallest;
  return value;
}

PlaneValue through_points(const Vec3& a, const Vec3& b, const Vec3& c) {
  PlaneValue value{};
  if (axis_parallel(a, b, c, value)) return value;
  const double u[3] = {b.x - a.x, b.y - a.y, b.z - a.z};
  const double v[3] = {c.x - a.x, c.y - a.y, c.z - a.z};
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const int i = next_axis(k), j = next_next_axis(k);
    const double left = u[i] * v[j], right = u[j] * v[i];
    value.n[k] = left - right;
    sum = std::max(sum, std::abs(left) + std::abs(right));
  }
  value.n_error = 8 * unit * sum + 4 * smallest;
  value = with_offset(value, a);
  BitRange bits;
  bits.add(a);
  bits.add(b);
  bits.add(c);
  if (bits.small()) {
    value.n_error = value.d_error = 0;
    value.exact = true;
  }
  return value;
}

PlaneValue along_axis(const Vec3& a, const Vec3& b, int axis) {
  const double u[3] = {b.x - a.x, b.y - a.y, b.z - a.z};
  PlaneValue value{};
  const int i = next_axis(axis), j = next_next_axis(axis);
  // u × e_axis
  value.n[i] = u[j];
  value.n[j] = -u[i];
  value.n_error = 2 * unit * (std::abs(u[i]) + std::abs(u[j])) + smallest;
  value = with_offset(value, a);
  BitRange bits;
  bits.add(a);
  bits.add(b);
  if (bits.small()) {
    value.n_error = value.d_error = 0;
    value.exact = true;
  }
  return value;
}

}  // namespace

PlaneValue plane_value(const Geometry& g, PlaneId plane) {
  using Kind = PlaneDefinition::Kind;
  const PlaneDefinition& s = g.definition(plane);
  switch (s.kind()) {
    case Kind::three_points:
      return through_points(g.positions[s.a], g.positions[s.b], g.positions[s.c]);
    case Kind::along_x:
    case Kind::along_y:
    case Kind::along_z:
      return along_axis(g.positions[s.a], g.positions[s.b], axis_of(s.kind()));
    case Kind::coefficients:
      break;
  }
  const PlaneCoefficients& k = g.coefficients[s.a];
  const double largest = std::max({std::abs(k.a), std::abs(k.b), std::abs(k.c), std::abs(k.d)});
  double least = largest;
  for (const double value : {k.a, k.b, k.c, k.d})
    if (value != 0) least = std::min(least, std::abs(value));
  return {{k.a, k.b, k.c}, k.d, 0, 0, largest < 0x1p200 && least > 0x1p-200};
}

ExactPlane exact_plane(const Geometry& g, PlaneId plane) {
  using Kind = PlaneDefinition::Kind;
  const PlaneDefinition& s = g.definition(plane);
  if (s.kind() == Kind::coefficients) {
    const PlaneCoefficients& k = g.coefficients[s.a];
    return {{Dyadic(k.a), Dyadic(k.b), Dyadic(k.c)}, Dyadic(k.d)};
  }
  const ExactVec a = exact_vec(g.positions[s.a]);
  const ExactVec u = exact_vec(g.positions[s.b]) - a;
  ExactVec v;
  if (s.kind() == Kind::three_points) {
    v = exact_vec(g.positions[s.c]) - a;
  } else {
    const int axis = axis_of(s.kind());
    v = exact_vec({axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0});
  }
  ExactPlane result;
  result.n[0] = minor(u.y, u.z, v.y, v.z);
  result.n[1] = minor(u.z, u.x, v.z, v.x);
  result.n[2] = minor(u.x, u.y, v.x, v.y);
  result.d = -(result.n[0] * a.x + result.n[1] * a.y + result.n[2] * a.z);
  return result;
}

namespace {

// line(u, v) ∩ s: u·w - side(u)·(v - u) with w = n·(v - u).
ExactPoint line_plane_point(const Vec3& from, const Vec3& to, const ExactPlane& s) {
  const ExactVec u = exact_vec(from), along = exact_vec(to) - u;
  const Dyadic w = s.n[0] * along.x + s.n[1] * along.y + s.n[2] * along.z;
  const Dyadic side = s.n[0] * u.x + s.n[1] * u.y + s.n[2] * u.z + s.d;
  return {u.x * w - side * along.x, u.y * w - side * along.y, u.z * w - side * along.z, w};
}

ExactPoint three_plane_point(const ExactPlane& a, const ExactPlane& b, const ExactPlane& c) {
  // Cramer's rule; bc = b × c and so on.
  const auto cross = [](const ExactPlane& p, const ExactPlane& q) {
    return ExactVec{minor(p.n[1], p.n[2], q.n[1], q.n[2]), minor(p.n[2], p.n[0], q.n[2], q.n[0]),
                    minor(p.n[0], p.n[1], q.n[0], q.n[1])};
  };
  const ExactVec bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
  return {-(a.d * bc.x + b.d * ca.x + c.d * ab.x), -(a.d * bc.y + b.d * ca.y + c.d * ab.y),
          -(a.d * bc.z + b.d * ca.z + c.d * ab.z), a.n[0] * bc.x + a.n[1] * bc.y + a.n[2] * bc.z};
}

template <class PlaneOf>
ExactPoint construct(const Geometry& g, const Construction& how, PlaneOf&& plane_of) {
  if (how.line_from.valid())
    return line_plane_point(g.position(how.line_from), g.position(how.line_to), plane_of(how.c));
  return three_plane_point(plane_of(how.a), plane_of(how.b), plane_of(how.c));
}

ExactPoint explicit_point(const Vec3& p) {
  return {Dyadic(p.x), Dyadic(p.y), Dyadic(p.z), Dyadic(1.0)};
}

template <class Value>
const Value& publish(std::atomic<const Value*>& slot, Value&& value) {
  const Value* made = new Value(std::move(value));
  const Value* seen = nullptr;
  if (slot.compare_exchange_strong(seen, made, std::memory_order_acq_rel)) return *made;
  delete made;
  return *seen;
}

// Grows a table of atomic pointers; vectors of atomics cannot be resized.
template <class Value>
void grow(std::vector<std::atomic<const Value*>>& table, std::size_t size) {
  if (table.size() >= size) return;
  std::vector<std::atomic<const Value*>> larger(std::max(size, table.size() * 3 / 2));
  for (std::size_t i = 0; i < table.size(); ++i)
    larger[i].store(table[i].load(std::memory_order_relaxed), std::memory_order_relaxed);
  table.swap(larger);
}

}  // namespace

ExactPoint exact_point(const Geometry& g, PointId point) {
  if (g.is_explicit(point)) return explicit_point(g.position(point));
  return construct(g, g.construction(point), [&](PlaneId s) { return exact_plane(g, s); });
}

Kernel::Kernel(const Geometry& geometry) : geometry_(geometry) {
  refresh();
}

Kernel::~Kernel() {
  for (auto& slot : exact_planes_) delete slot.load(std::memory_order_relaxed);
  for (auto& slot : exact_points_) delete slot.load(std::memory_order_relaxed);
}

void Kernel::refresh() {
  const std::size_t known = values_.size(), count = geometry_.planes.size();
  values_.resize(count);
  const auto fill = [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) values_[i] = plane_value(geometry_, PlaneId(i));
  };
  if (count - known < 4096) {
    fill(known, count);
  } else {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(known, count, 4096),
                      [&](const auto& range) { fill(range.begin(), range.end()); });
  }
  grow(exact_planes_, count);
  grow(exact_points_, geometry_.positions.size());
}

void Kernel::refresh_all() {
  values_.clear();
  for (auto& slot : exact_planes_) delete slot.exchange(nullptr, std::memory_order_relaxed);
  refresh();
}

const ExactPlane& Kernel::exact(PlaneId s) const {
  auto& slot = exact_planes_[s.value()];
  if (const ExactPlane* known = slot.load(std::memory_order_acquire)) return *known;
  return publish(slot, exact_plane(geometry_, s));
}

const ExactPoint& Kernel::exact(PointId p) const {
  auto& slot = exact_points_[p.value()];
  if (const ExactPoint* known = slot.load(std::memory_order_acquire)) return *known;
  if (geometry_.is_explicit(p)) return publish(slot, explicit_point(geometry_.position(p)));
  return publish(slot, construct(geometry_, geometry_.construction(p),
                                 [&](PlaneId s) -> const ExactPlane& { return exact(s); }));
}

ExactPoint Kernel::exact(const Construction& how) const {
  return construct(geometry_, how, [&](PlaneId s) -> const ExactPlane& { return exact(s); });
}

Estimate Kernel::estimate(PointId point, PlaneId plane) const {
  const PlaneValue& s = value(plane);
  const Vec3& p = geometry_.position(point);
  const double x = s.n[0] * p.x, y = s.n[1] * p.y, z = s.n[2] * p.z;
  // An implicit point's position is off by half an ulp at most: one more rounding each.
  const double sum = std::abs(x) + std::abs(y) + std::abs(z) + std::abs(s.d);
  const double error = 12 * unit * sum + 8 * smallest + s.d_error +
                       s.n_error * (std::abs(p.x) + std::abs(p.y) + std::abs(p.z)) * (1 + 8 * unit);
  return {x + y + z + s.d, error};
}

Sign Kernel::side(PointId point, PlaneId plane) const {
  const Estimate value = estimate(point, plane);
  return value.decided() ? value.sign() : exact_side(point, plane);
}

namespace {

// Is this one of the points through which the plane is laid?
bool defines(const Geometry& geometry, const Vec3& p, const PlaneDefinition& plane) {
  const PlaneDefinition::Kind kind = plane.kind();
  if (kind == PlaneDefinition::Kind::coefficients) return false;
  const auto is = [&](std::uint32_t id) { return geometry.position(PointId(id)) == p; };
  return is(plane.a) || is(plane.b) || (kind == PlaneDefinition::Kind::three_points && is(plane.c));
}

}  // namespace

Sign Kernel::exact_side(PointId point, PlaneId plane) const {
  const PlaneValue& s = value(plane);
  const Vec3& p = geometry_.position(point);
  if (geometry_.is_explicit(point)) {
    if (defines(geometry_, p, geometry_.definition(plane))) return Sign::zero;
    if (s.exact) {
      const double a[4] = {s.n[0], s.n[1], s.n[2], s.d}, b[4] = {p.x, p.y, p.z, 1};
      return sign_of_dot(a, b, 4);
    }
    const ExactPlane& e = exact(plane);
    return (e.n[0] * Dyadic(p.x) + e.n[1] * Dyadic(p.y) + e.n[2] * Dyadic(p.z) + e.d).sign();
  }
  const Construction& how = geometry_.construction(point);
  if (how.a == plane || how.b == plane || how.c == plane) return Sign::zero;
  const ExactPlane& e = exact(plane);
  const ExactPoint& q = exact(point);
  return (e.n[0] * q.x + e.n[1] * q.y + e.n[2] * q.z + e.d * q.w).sign() * q.w.sign();
}

Sign Kernel::det(PlaneId a, PlaneId b, PlaneId c) const {
  if (a == b || b == c || c == a) return Sign::zero;
  const PlaneValue &u = value(a), &v = value(b), &w = value(c);
  double sum = 0, permanent = 0;
  for (int k = 0; k < 3; ++k) {
    const int i = next_axis(k), j = next_next_axis(k);
    const double left = v.n[i] * w.n[j], right = v.n[j] * w.n[i];
    sum += u.n[k] * (left - right);
    permanent += std::abs(u.n[k]) * (std::abs(left) + std::abs(right));
  }
  const auto length = [](const PlaneValue& s) {
    return std::abs(s.n[0]) + std::abs(s.n[1]) + std::abs(s.n[2]) + 3 * s.n_error;
  };
  const double lu = length(u), lv = length(v), lw = length(w);
  const bool exact_operands = u.exact && v.exact && w.exact;
  double error = 16 * unit * permanent;
  if (!exact_operands)
    error += 2 * (u.n_error * lv * lw + v.n_error * lu * lw + w.n_error * lu * lv) + 32 * smallest;
  const Estimate verdict{sum, error};
  if (verdict.decided()) return verdict.sign();
  if (exact_operands && permanent == 0) return Sign::zero;
  const ExactPlane &p = exact(a), &q = exact(b), &r = exact(c);
  return (p.n[0] * minor(q.n[1], q.n[2], r.n[1], r.n[2]) +
          p.n[1] * minor(q.n[2], q.n[0], r.n[2], r.n[0]) +
          p.n[2] * minor(q.n[0], q.n[1], r.n[0], r.n[1]))
      .sign();
}

Sign Kernel::cross(PlaneId a, PlaneId b, int axis) const {
  if (a == b) return Sign::zero;
  const PlaneValue &u = value(a), &v = value(b);
  const int i = next_axis(axis), j = next_next_axis(axis);
  const double left = u.n[i] * v.n[j], right = u.n[j] * v.n[i];
  const double sum = std::abs(left) + std::abs(right);
  double error = 4 * unit * sum;
  const bool exact_operands = u.exact && v.exact;
  if (!exact_operands)
    error += 2 * (u.n_error * (std::abs(v.n[i]) + std::abs(v.n[j]) + v.n_error) +
                  v.n_error * (std::abs(u.n[i]) + std::abs(u.n[j]) + u.n_error)) +
             8 * smallest;
  const Estimate verdict{left - right, error};
  if (verdict.decided()) return verdict.sign();
  if (exact_operands) {
    if (sum == 0) return Sign::zero;
    const double p[2] = {u.n[i], u.n[j]}, q[2] = {v.n[j], -v.n[i]};
    return sign_of_dot(p, q, 2);
  }
  const ExactPlane &p = exact(a), &q = exact(b);
  return minor(p.n[i], p.n[j], q.n[i], q.n[j]).sign();
}

int Kernel::cross_axis(PlaneId a, PlaneId b) const {
  if (a == b) return -1;
  const PlaneValue &u = value(a), &v = value(b);
  double size[3];
  int order[3] = {0, 1, 2};
  for (int k = 0; k < 3; ++k) {
    const int i = next_axis(k), j = next_next_axis(k);
    size[k] = std::abs(u.n[i] * v.n[j] - u.n[j] * v.n[i]);
  }
  if (size[order[1]] > size[order[0]]) std::swap(order[0], order[1]);
  if (size[order[2]] > size[order[0]]) std::swap(order[0], order[2]);
  for (const int k : order)
    if (cross(a, b, k) != Sign::zero) return k;
  return -1;
}

Sign Kernel::normal(PlaneId a, int axis) const {
  const PlaneValue& s = value(a);
  if (std::abs(s.n[axis]) > s.n_error || s.exact) return sign_of(s.n[axis]);
  return exact(a).n[axis].sign();
}

int Kernel::main_axis(PlaneId a) const {
  const PlaneValue& s = value(a);
  const double x = std::abs(s.n[0]), y = std::abs(s.n[1]), z = std::abs(s.n[2]);
  const int largest = x >= y ? (x >= z ? 0 : 2) : (y >= z ? 1 : 2);
  if (normal(a, largest) != Sign::zero) return largest;
  const int other = next_axis(largest);
  return normal(a, other) != Sign::zero ? other : next_axis(other);
}

bool Kernel::same_direction(PlaneId a, PlaneId b) const {
  if (a == b) return true;
  const int axis = main_axis(a);
  return normal(a, axis) == normal(b, axis);
}

bool Kernel::coplanar(PlaneId a, PlaneId b) const {
  if (a == b) return true;
  if (!parallel(a, b)) return false;
  for (const auto& [s, t] : {std::pair{a, b}, std::pair{b, a}}) {
    const PlaneDefinition& how = geometry_.definition(t);
    if (how.kind() != PlaneDefinition::Kind::coefficients)
      return side(PointId(how.a), s) == Sign::zero;
  }
  const int axis = main_axis(a);
  const ExactPlane &p = exact(a), &q = exact(b);
  return (p.n[axis] * q.d - q.n[axis] * p.d).sign() == Sign::zero;
}

Sign Kernel::compare(PointId p, PointId q, int axis) const {
  // Rounding to nearest is monotonic: only equal rounded coordinates leave anything open.
  const double x = component(geometry_.position(p), axis);
  const double y = component(geometry_.position(q), axis);
  if (x != y) return x < y ? Sign::positive : Sign::negative;
  if (p == q || (geometry_.is_explicit(p) && geometry_.is_explicit(q))) return Sign::zero;
  const ExactPoint &u = exact(p), &v = exact(q);
  return (component(v, axis) * u.w - component(u, axis) * v.w).sign() * u.w.sign() * v.w.sign();
}

bool Kernel::same_point(PointId p, PointId q) const {
  if (p == q) return true;
  if (!(geometry_.position(p) == geometry_.position(q))) return false;
  if (geometry_.is_explicit(p)) {
    if (geometry_.is_explicit(q)) return true;
    std::swap(p, q);
  }
  const Construction& how = geometry_.construction(p);
  return side(q, how.a) == Sign::zero && side(q, how.b) == Sign::zero &&
         side(q, how.c) == Sign::zero;
}

Sign Kernel::turn(PointId p, PointId q, PointId r, int axis) const {
  const int i = next_axis(axis), j = next_next_axis(axis);
  const Vec3 &a = geometry_.position(p), &b = geometry_.position(q), &c = geometry_.position(r);
  const double ai = component(a, i), aj = component(a, j), bi = component(b, i),
               bj = component(b, j), ci = component(c, i), cj = component(c, j);
  const double left = (bi - ai) * (cj - aj), right = (bj - aj) * (ci - ai);
  const bool all_explicit =
      geometry_.is_explicit(p) && geometry_.is_explicit(q) && geometry_.is_explicit(r);
  double error = 8 * unit * (std::abs(left) + std::abs(right)) + 8 * smallest;
  if (!all_explicit) {
    const double hi = 4 * unit * (std::abs(ai) + std::abs(bi) + std::abs(ci)) + 4 * smallest;
    const double hj = 4 * unit * (std::abs(aj) + std::abs(bj) + std::abs(cj)) + 4 * smallest;
    error += 2 * (hi * (std::abs(cj - aj) + std::abs(bj - aj) + hj) +
                  hj * (std::abs(bi - ai) + std::abs(ci - ai) + hi));
  }
  const Estimate verdict{left - right, error};
  if (verdict.decided()) return verdict.sign();
  if (all_explicit) return exact_turn(a, b, c, axis);
  const ExactPoint &u = exact(p), &v = exact(q), &w = exact(r);
  const Dyadic &ui = component(u, i), &uj = component(u, j), &vi = component(v, i),
               &vj = component(v, j), &wi = component(w, i), &wj = component(w, j);
  // The determinant of the three homogeneous points.
  const Dyadic value =
      ui * minor(vj, v.w, wj, w.w) - uj * minor(vi, v.w, wi, w.w) + u.w * minor(vi, vj, wi, wj);
  return value.sign() * u.w.sign() * v.w.sign() * w.w.sign();
}

}  // namespace sectile
