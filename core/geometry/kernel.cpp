#include "geometry/kernel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geometry/same_definition.h"
#include "numbers/rounding.h"
#include "parallel/parallel.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

// Bounds are for counted roundings, rounded up amply.
using rounding::underflow;
using rounding::unit;

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

template <class Value>
void clear(std::vector<std::atomic<const Value*>>& table) {
  for (auto& slot : table)
    if (slot.load(std::memory_order_relaxed) != nullptr)  // as hardly any is
      delete slot.exchange(nullptr, std::memory_order_relaxed);
}

Vec3 rounded(const ExactPoint& p) {
  if (p.w.sign() == Sign::zero) throw InternalError("planes that are to meet in a point do not");
  return {nearest_quotient(p.x[0], p.w), nearest_quotient(p.x[1], p.w),
          nearest_quotient(p.x[2], p.w)};
}

bool equals(const ExactPoint& e, const Vec3& p) {
  for (int axis = 0; axis < 3; ++axis) {
    const double at = component(p, axis);
    if (!std::isfinite(at) || (e.x[axis] - Dyadic(at) * e.w).sign() != Sign::zero) return false;
  }
  return true;
}

}  // namespace

Kernel::Kernel(const Geometry& geometry) : geometry_(geometry) {
  refresh();
}

Kernel::Kernel(const Geometry& geometry, std::span<const PlaneId> some) : geometry_(geometry) {
  constexpr double anything = std::numeric_limits<double>::infinity();
  values_.assign(geometry.planes.size(), {{0, 0, 0}, 0, anything, anything, false});
  for (const PlaneId s : some) values_[s.value()] = plane_value(geometry, s);
  make_room();
}

Kernel::~Kernel() {
  clear(bounded_planes_);
  clear(exact_planes_);
  clear(exact_points_);
}

void Kernel::refresh() {
  const std::size_t known = values_.size(), count = geometry_.planes.size();
  values_.resize(count);
  const auto fill = [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) values_[i] = plane_value(geometry_, PlaneId(i));
  };
  if (known < count)
    parallel::loop(parallel::Range<std::size_t>(known, count, 512),
                   [&](const auto& range) { fill(range.begin(), range.end()); });
  make_room();
}

void Kernel::make_room() {
  grow(bounded_planes_, geometry_.planes.size());
  grow(exact_planes_, geometry_.planes.size());
  grow(exact_points_, geometry_.positions.size());
}

void Kernel::refresh_all() {
  values_.clear();
  clear(bounded_planes_);
  clear(exact_planes_);
  refresh();
}

const ExactPlane& Kernel::exact(PlaneId s) const {
  auto& slot = exact_planes_[s.value()];
  if (const ExactPlane* known = slot.load(std::memory_order_acquire)) return *known;
  return publish(slot, plane_of<Dyadic>(geometry_, s));
}

const ExactPoint& Kernel::exact(PointId p) const {
  auto& slot = exact_points_[p.value()];
  if (const ExactPoint* known = slot.load(std::memory_order_acquire)) return *known;
  return publish(slot, geometry_.is_constructed(p) ? exact(geometry_.construction(p))
                                                   : given_point<Dyadic>(geometry_, p));
}

ExactPoint Kernel::exact(const Construction& how) const {
  return constructed_point<Dyadic>(geometry_, how,
                                   [&](PlaneId s) -> const ExactPlane& { return exact(s); });
}

const BoundedPlane& Kernel::bounded(PlaneId s) const {
  auto& slot = bounded_planes_[s.value()];
  if (const BoundedPlane* known = slot.load(std::memory_order_acquire)) return *known;
  const PlaneValue& v = value(s);
  return publish(slot, v.exact ? plane_of<Bounded>({v.n[0], v.n[1], v.n[2], v.d})
                               : plane_of<Bounded>(geometry_, s));
}

BoundedPoint Kernel::bounded(const Construction& how) const {
  return constructed_point<Bounded>(geometry_, how,
                                    [&](PlaneId s) -> const BoundedPlane& { return bounded(s); });
}

// A line along an axis meets a plane across that axis: nothing has to be computed.
std::optional<Vec3> Kernel::along_axis(const Construction& how) const {
  const PlaneValue& s = value(how.c);
  if (!how.line_from.valid() || !s.exact || !geometry_.is_explicit(how.line_from) ||
      !geometry_.is_explicit(how.line_to))
    return std::nullopt;
  Vec3 at = geometry_.position(how.line_from);
  const Vec3& to = geometry_.position(how.line_to);
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(s.n[axis]) != 1 || s.n[next_axis(axis)] != 0 || s.n[next_next_axis(axis)] != 0)
      continue;
    component(at, axis) = component(to, axis);
    if (!(at == to)) return std::nullopt;
    component(at, axis) = s.n[axis] > 0 ? 0 - s.d : 0 + s.d;  // no negative zeros
    return at;
  }
  return std::nullopt;
}

std::array<Bounded, 3> Kernel::bounded_place(const Construction& how) const {
  if (!how.line_from.valid()) {
    const BoundedPoint p = bounded(how);
    return {quotient(p.x[0], p.w), quotient(p.x[1], p.w), quotient(p.x[2], p.w)};
  }
  // u + t (v - u) takes one quotient for all three.
  const BoundedPlane& s = bounded(how.c);
  const BoundedPoint u = given_point<Bounded>(geometry_, how.line_from);
  Bounded along[3];
  difference(geometry_, how.line_from, how.line_to, along);
  const Bounded t = quotient(-(dot(s.n, u.x) + s.d), dot(s.n, along));
  return {u.x[0] + t * along[0], u.x[1] + t * along[1], u.x[2] + t * along[2]};
}

ConstructedPoint Kernel::construct(const Construction& how) const {
  if (const auto at = along_axis(how)) return {*at, true};
  const std::array<Bounded, 3> near = bounded_place(how);
  const auto x = near[0].nearest(), y = near[1].nearest(), z = near[2].nearest();
  if (x && y && z && (x->inexact || y->inexact || z->inexact))
    return {{x->value, y->value, z->value}, false};
  const ExactPoint point = exact(how);
  const Vec3 position = rounded(point);
  return {position, equals(point, position)};
}

Estimate Kernel::estimate(const Vec3& p, PlaneId plane) const {
  const PlaneValue& s = value(plane);
  const double x = s.n[0] * p.x, y = s.n[1] * p.y, z = s.n[2] * p.z;
  // An implicit point's position is off by half an ulp at most: one more rounding each. Near zero
  // that is half the least double, whatever the normal makes of it.
  const double sum = std::abs(x) + std::abs(y) + std::abs(z) + std::abs(s.d);
  const double size = std::abs(p.x) + std::abs(p.y) + std::abs(p.z) + 4 * underflow;
  const double error = 12 * unit * sum + s.d_error +
                       underflow * (8 + std::abs(s.n[0]) + std::abs(s.n[1]) + std::abs(s.n[2])) +
                       s.n_error * size * (1 + 8 * unit);
  return {x + y + z + s.d, error};
}

std::optional<double> Kernel::level(const Construction& how, int axis) const {
  for (const PlaneId s : {how.a, how.b, how.c})
    if (s.valid() && value(s).axis == axis) return value(s).n[axis] > 0 ? -value(s).d : value(s).d;
  if (!how.line_from.valid() || !geometry_.is_explicit(how.line_from) ||
      !geometry_.is_explicit(how.line_to))
    return {};
  const double at = component(geometry_.position(how.line_from), axis);
  if (component(geometry_.position(how.line_to), axis) != at) return {};
  return at;
}

std::optional<double> Kernel::level(PointId p, int axis) const {
  if (geometry_.is_constructed(p)) return level(geometry_.construction(p), axis);
  if (!geometry_.is_explicit(p)) return {};
  return component(geometry_.position(p), axis);
}

std::optional<Sign> Kernel::level_side(const Construction& how, PlaneId plane) const {
  const PlaneValue& s = value(plane);
  if (s.axis < 0) return {};
  const auto at = level(how, s.axis);
  if (!at) return {};
  return sign_of(s.n[s.axis] * *at + s.d);  // the sign of a sum of two is right
}

Sign Kernel::side(PointId point, PlaneId plane) const {
  const Estimate value = estimate(point, plane);
  return value.decided() ? value.sign() : exact_side(point, plane);
}

namespace {

// Is this one of the points through which the plane is laid?
bool defines(const Geometry& geometry, PointId p, const PlaneDefinition& plane) {
  if (!plane.has_points()) return false;
  const auto is = [&](std::uint32_t id) { return clearly_same(geometry, p, PointId(id)); };
  return is(plane.a) || is(plane.b) ||
         (plane.kind() == PlaneDefinition::Kind::three_points && is(plane.c));
}

// The axis on which alone two points differ, or none.
int only_difference(const Vec3& p, const Vec3& q) {
  int axis = -1;
  for (int k = 0; k < 3; ++k) {
    if (component(p, k) == component(q, k)) continue;
    if (axis >= 0) return -1;
    axis = k;
  }
  return axis;
}

// Does the plane run along an axis on which alone the point differs from one through which the
// plane is laid? So it is with the corners of two prisms that stand one on the other.
bool stands_on(const Geometry& geometry, PointId p, const PlaneDefinition& plane) {
  if (plane.kind() != PlaneDefinition::Kind::three_points || !geometry.is_explicit(p)) return false;
  const std::array<PointId, 3> points{PointId(plane.a), PointId(plane.b), PointId(plane.c)};
  for (const PointId q : points)
    if (!geometry.is_explicit(q)) return false;
  const auto differ = [&](PointId q, PointId r) {
    return only_difference(geometry.position(q), geometry.position(r));
  };
  const auto runs_along = [&](int axis) {
    return differ(points[0], points[1]) == axis || differ(points[1], points[2]) == axis ||
           differ(points[2], points[0]) == axis;
  };
  return std::ranges::any_of(points, [&](PointId q) {
    const int axis = differ(p, q);
    return axis >= 0 && runs_along(axis);
  });
}

}  // namespace

Sign Kernel::exact_side(PointId point, PlaneId plane) const {
  const PlaneValue& s = value(plane);
  if (!geometry_.is_constructed(point)) {
    if (s.axis >= 0 && geometry_.is_explicit(point))  // the sign of a sum of two is right
      return sign_of(s.n[s.axis] * component(geometry_.position(point), s.axis) + s.d);
    const PlaneDefinition& definition = geometry_.definition(plane);
    if (defines(geometry_, point, definition) || stands_on(geometry_, point, definition))
      return Sign::zero;
    if (s.exact && geometry_.is_explicit(point)) {
      const Vec3& p = geometry_.position(point);
      const double a[4] = {s.n[0], s.n[1], s.n[2], s.d}, b[4] = {p.x, p.y, p.z, 1};
      return sign_of_dot(a, b, 4);
    }
    const Bounded near = value_at(bounded(plane), given_point<Bounded>(geometry_, point));
    if (near.decided()) return near.sign();
    if (geometry_.is_moved(point)) return value_at(exact(plane), exact(point)).sign();
    return value_at(exact(plane), point_of<Dyadic>(geometry_.position(point))).sign();
  }
  const Construction& how = geometry_.construction(point);
  if (how.a == plane || how.b == plane || how.c == plane) return Sign::zero;
  if (const auto known = level_side(how, plane)) return *known;
  // Short numbers are exact in no more time.
  if (!s.exact || !value(how.c).exact) {
    const BoundedPoint q = bounded(how);
    const Bounded near = value_at(bounded(plane), q);
    if (near.decided() && q.w.decided()) return near.sign() * q.w.sign();
  }
  const ExactPoint& q = exact(point);
  return value_at(exact(plane), q).sign() * q.w.sign();
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
  // A product of two factors that underflows is off by the least double times the third factor.
  if (!exact_operands)
    error += 2 * (u.n_error * lv * lw + v.n_error * lu * lw + w.n_error * lu * lv) +
             4 * underflow * (lu + lv + lw) + 32 * underflow;
  const Estimate verdict{sum, error};
  if (verdict.decided()) return verdict.sign();
  if (exact_operands && permanent == 0) return Sign::zero;
  if (!exact_operands) {
    const Bounded near = determinant(bounded(a).n, bounded(b).n, bounded(c).n);
    if (near.decided()) return near.sign();
  }
  return determinant(exact(a).n, exact(b).n, exact(c).n).sign();
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
             8 * underflow;
  const Estimate verdict{left - right, error};
  if (verdict.decided()) return verdict.sign();
  if (exact_operands) {
    if (sum == 0) return Sign::zero;
    const double p[2] = {u.n[i], u.n[j]}, q[2] = {v.n[j], -v.n[i]};
    return sign_of_dot(p, q, 2);
  }
  const BoundedPlane &near_a = bounded(a), &near_b = bounded(b);
  const Bounded near = minor(near_a.n[i], near_a.n[j], near_b.n[i], near_b.n[j]);
  if (near.decided()) return near.sign();
  const ExactPlane &p = exact(a), &q = exact(b);
  return minor(p.n[i], p.n[j], q.n[i], q.n[j]).sign();
}

Estimate Kernel::estimated_cross(PlaneId a, PlaneId b, int& largest) const {
  const PlaneValue &u = value(a), &v = value(b);
  double component[3], sum = 0;
  for (int k = 0; k < 3; ++k) {
    const int i = next_axis(k), j = next_next_axis(k);
    const double left = u.n[i] * v.n[j], right = u.n[j] * v.n[i];
    component[k] = left - right;
    sum += std::abs(left) + std::abs(right);
  }
  largest = std::abs(component[1]) > std::abs(component[0]) ? 1 : 0;
  if (std::abs(component[2]) > std::abs(component[largest])) largest = 2;
  double error = 4 * unit * sum + 8 * underflow;
  if (!u.exact || !v.exact) {
    const auto size = [](const PlaneValue& s) {
      return std::abs(s.n[0]) + std::abs(s.n[1]) + std::abs(s.n[2]) + s.n_error;
    };
    error += 2 * (u.n_error * size(v) + v.n_error * size(u));
  }
  return {component[largest], error};
}

Kernel::AxisSign Kernel::main_cross(PlaneId a, PlaneId b) const {
  if (a == b) return {-1, Sign::zero};
  if (const PlaneValue& u = value(a), &v = value(b); u.axis >= 0 && v.axis >= 0) {
    if (u.axis == v.axis) return {-1, Sign::zero};
    const double product = u.n[u.axis] * v.n[v.axis];
    const bool right_handed = next_axis(u.axis) == v.axis;
    return {3 - u.axis - v.axis, sign_of(right_handed ? product : -product)};
  }
  int largest;
  const Estimate component = estimated_cross(a, b, largest);
  if (component.decided()) return {largest, component.sign()};
  for (const int axis : {largest, next_axis(largest), next_next_axis(largest)})
    if (const Sign sign = cross(a, b, axis); sign != Sign::zero) return {axis, sign};
  return {-1, Sign::zero};
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
    if (how.has_points()) return side(PointId(how.a), s) == Sign::zero;
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
  if (p == q || (level(p, axis) && level(q, axis))) return Sign::zero;
  const ExactPoint &u = exact(p), &v = exact(q);
  return minor(v.x[axis], v.w, u.x[axis], u.w).sign() * u.w.sign() * v.w.sign();
}

bool Kernel::is_between(PointId from, PointId p, PointId to) const {
  for (int axis = 0; axis < 3; ++axis)
    if (const Sign way = compare(from, to, axis); way != Sign::zero)
      return compare(from, p, axis) == way && compare(p, to, axis) == way;
  return false;
}

bool Kernel::same_point(PointId p, PointId q) const {
  if (p == q) return true;
  if (!(geometry_.position(p) == geometry_.position(q))) return false;
  if (!geometry_.is_constructed(p)) {
    if (!geometry_.is_constructed(q)) {
      if (geometry_.is_explicit(p) && geometry_.is_explicit(q)) return true;
      if (clearly_same(geometry_, p, q)) return true;
      const ExactPoint &u = exact(p), &v = exact(q);
      return u.x[0] == v.x[0] && u.x[1] == v.x[1] && u.x[2] == v.x[2];
    }
    std::swap(p, q);
  }
  const Construction& how = geometry_.construction(p);
  return side(q, how.a) == Sign::zero && side(q, how.b) == Sign::zero &&
         side(q, how.c) == Sign::zero;
}

Estimate Kernel::estimated_turn(const Vec3& a, const Vec3& b, const Vec3& c, int axis, bool exact) {
  const int i = next_axis(axis), j = next_next_axis(axis);
  const double ai = component(a, i), aj = component(a, j), bi = component(b, i),
               bj = component(b, j), ci = component(c, i), cj = component(c, j);
  const double left = (bi - ai) * (cj - aj), right = (bj - aj) * (ci - ai);
  double error = 8 * unit * (std::abs(left) + std::abs(right)) + 8 * underflow;
  if (!exact) {
    const double hi = 4 * unit * (std::abs(ai) + std::abs(bi) + std::abs(ci)) + 4 * underflow;
    const double hj = 4 * unit * (std::abs(aj) + std::abs(bj) + std::abs(cj)) + 4 * underflow;
    error += 2 * (hi * (std::abs(cj - aj) + std::abs(bj - aj) + hj) +
                  hj * (std::abs(bi - ai) + std::abs(ci - ai) + hi));
  }
  return {left - right, error};
}

Sign Kernel::turn(PointId p, PointId q, PointId r, int axis) const {
  const Vec3 &a = geometry_.position(p), &b = geometry_.position(q), &c = geometry_.position(r);
  const bool all_explicit =
      geometry_.is_explicit(p) && geometry_.is_explicit(q) && geometry_.is_explicit(r);
  const Estimate verdict = estimated_turn(a, b, c, axis, all_explicit);
  if (verdict.decided()) return verdict.sign();
  if (all_explicit) {
    const Bounded near = turn_of<Bounded>(a, b, c, axis);
    return near.decided() ? near.sign() : turn_of<Dyadic>(a, b, c, axis).sign();
  }
  const ExactPoint &u = exact(p), &v = exact(q), &w = exact(r);
  return turn_of(u, v, w, axis).sign() * u.w.sign() * v.w.sign() * w.w.sign();
}

}  // namespace sectile
