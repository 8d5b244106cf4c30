#include "arrangement/winding.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/axes.h"
#include "geometry/x_ray.h"

namespace sectile::arrangement {

void add(Winding& winding, const Winding& step, int sign, Counting counting) {
  for (const auto& [operand, by] : step) {
    auto at = std::lower_bound(winding.begin(), winding.end(), operand,
                               [](const auto& entry, std::uint32_t o) { return entry.first < o; });
    if (at == winding.end() || at->first != operand) at = winding.insert(at, {operand, 0});
    at->second += sign * by;
    if (counting == Counting::parity) at->second &= 1;
    if (at->second == 0) winding.erase(at);
  }
}

RayStart::RayStart(ExactPoint exact)
    : point(std::move(exact)),
      rounded{nearest_quotient(point.x[0], point.w), nearest_quotient(point.x[1], point.w),
              nearest_quotient(point.x[2], point.w)} {}

Sign WindingRay::side(const RayStart& start, PlaneId plane) const {
  if (const Estimate e = kernel_.estimate(start.rounded, plane); e.decided()) return e.sign();
  if (const Sign s = value_at(kernel_.exact(plane), start.point).sign(); s != Sign::zero) return s;
  const int next = next_axis(axis_), last = next_next_axis(axis_);
  if (const Sign s = kernel_.normal(plane, last); s != Sign::zero) return -s;
  if (const Sign s = kernel_.normal(plane, next); s != Sign::zero) return s;
  return kernel_.normal(plane, axis_);
}

bool WindingRay::meets(const RayStart& start, std::uint32_t face) const {
  const ExactPoint& point = start.point;
  const Geometry& geometry = kernel_.geometry();
  const int next = next_axis(axis_);
  const double height = component(start.rounded, next);
  const auto above = [&](PointId p) {
    // Rounding to nearest is monotonic.
    const double at = component(geometry.position(p), next);
    if (at != height) return at > height;
    const ExactPoint& q = kernel_.exact(p);
    const auto i = static_cast<std::size_t>(next);
    return minor(q.x[i], q.w, point.x[i], point.w).sign() * q.w.sign() == Sign::positive;
  };
  XRayParity parity;
  for (std::uint32_t c = facets_.begin(face); c < facets_.end(face); ++c) {
    const PointId u = facets_.from(c), v = facets_.to(c);
    parity.add(above(u), above(v), [&] {
      const Estimate turn = Kernel::estimated_turn(geometry.position(u), geometry.position(v),
                                                   start.rounded, axis_, false);
      if (turn.decided()) return turn.sign();
      const ExactPoint &p = kernel_.exact(u), &q = kernel_.exact(v);
      return turn_of(p, q, point, axis_).sign() * p.w.sign() * q.w.sign();
    });
  }
  return parity.odd();
}

std::vector<std::uint32_t> WindingRay::near_faces(const RayStart& start) const {
  constexpr double far = std::numeric_limits<double>::infinity();
  double low[3], high[3];
  for (int axis = 0; axis < 3; ++axis) {
    const double at = component(start.rounded, axis);
    low[axis] = std::nextafter(at, -far);
    high[axis] = axis == axis_ ? far : std::nextafter(at, far);
  }
  const auto meets = [&](const Box& b) {
    bool all = true;
    for (int axis = 0; axis < 3; ++axis)
      all &= b.low[axis] <= high[axis] && low[axis] <= b.high[axis];
    return all;
  };
  std::vector<std::uint32_t> faces;
  tree_.query(meets, [&](std::uint32_t f) { faces.push_back(f); });
  std::sort(faces.begin(), faces.end());
  return faces;
}

std::vector<WindingRay::Hit> WindingRay::hits(const RayStart& start) const {
  std::vector<Hit> found;
  for (const std::uint32_t f : near_faces(start)) {
    const PlaneId plane = facets_.plane[f];
    const Sign normal = kernel_.normal(plane, axis_);
    if (normal == Sign::zero || side(start, plane) != -normal || !meets(start, f)) continue;
    found.push_back({f, normal == Sign::positive ? 1 : -1});
  }
  return found;
}

}  // namespace sectile::arrangement
