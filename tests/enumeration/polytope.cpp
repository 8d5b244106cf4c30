#include "polytope.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace sectile::test {
namespace {

using Corners = std::vector<LatticePoint>;

LatticePlane plane_through(const LatticePoint& p, const LatticePoint& q, const LatticePoint& r) {
  const std::int64_t ux = q.x - p.x, uy = q.y - p.y, uz = q.z - p.z;
  const std::int64_t vx = r.x - p.x, vy = r.y - p.y, vz = r.z - p.z;
  LatticePlane plane{uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx, 0};
  const std::int64_t divisor = std::gcd(std::gcd(plane.a, plane.b), plane.c);
  if (divisor == 0) return plane;
  plane = {plane.a / divisor, plane.b / divisor, plane.c / divisor, 0};
  plane.d = plane.a * p.x + plane.b * p.y + plane.c * p.z;
  return plane;
}

LatticePlane turned(const LatticePlane& p) {
  return {-p.a, -p.b, -p.c, -p.d};
}

// Positive if the integer points p, q, r turn left, seen against the normal.
std::int64_t turn(const LatticePlane& plane, const LatticePoint& p, const LatticePoint& q,
                  const LatticePoint& r) {
  const LatticePlane n = {(q.y - p.y) * (r.z - p.z) - (q.z - p.z) * (r.y - p.y),
                          (q.z - p.z) * (r.x - p.x) - (q.x - p.x) * (r.z - p.z),
                          (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x), 0};
  return n.a * plane.a + n.b * plane.b + n.c * plane.c;
}

// q lies between p and r, or is p; all three are on one line.
bool is_between(const LatticePoint& p, const LatticePoint& q, const LatticePoint& r) {
  return (q.x - p.x) * (r.x - q.x) + (q.y - p.y) * (r.y - q.y) + (q.z - p.z) * (r.z - q.z) >= 0;
}

// The corners of the convex hull of integer points in a plane, counter-clockwise.
Corners wrapped(const LatticePlane& plane, const Corners& points) {
  const LatticePoint start = *std::min_element(points.begin(), points.end());
  Corners corners;
  LatticePoint at = start;
  do {
    corners.push_back(at);
    LatticePoint next = at;
    for (const LatticePoint& p : points) {
      if (p == at) continue;
      const std::int64_t side = next == at ? -1 : turn(plane, at, next, p);
      if (side < 0 || (side == 0 && is_between(at, next, p))) next = p;
    }
    at = next;
  } while (at != start);
  return corners;
}

LatticePoint crossing(const LatticePoint& p, std::int64_t side_p, const LatticePoint& q,
                      std::int64_t side_q) {
  return LatticePoint::reduced(side_p * q.x - side_q * p.x, side_p * q.y - side_q * p.y,
                               side_p * q.z - side_q * p.z, side_p * q.w - side_q * p.w);
}

// Sutherland and Hodgman's step: the part of a convex polygon on or behind a plane.
Corners clip(const Corners& polygon, const LatticePlane& plane) {
  Corners result;
  const auto add = [&](const LatticePoint& p) {
    if (result.empty() || result.back() != p) result.push_back(p);
  };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const LatticePoint &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const std::int64_t at_p = plane.side(p), at_q = plane.side(q);
    if (at_p <= 0) add(p);
    if ((at_p < 0 && at_q > 0) || (at_p > 0 && at_q < 0)) add(crossing(p, at_p, q, at_q));
  }
  if (result.size() > 1 && result.front() == result.back()) result.pop_back();
  return result;
}

Corners clip(Corners polygon, const std::vector<Polytope::Facet>& by) {
  for (const Polytope::Facet& facet : by) polygon = clip(polygon, facet.plane);
  return polygon;
}

}  // namespace

LatticePoint LatticePoint::reduced(std::int64_t x, std::int64_t y, std::int64_t z, std::int64_t w) {
  const std::int64_t divisor = std::gcd(std::gcd(x, y), std::gcd(z, w)) * (w < 0 ? -1 : 1);
  return {x / divisor, y / divisor, z / divisor, w / divisor};
}

Rational six_volumes(const std::vector<LatticePoint>& polygon) {
  Rational sum = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const LatticePoint &p = polygon[0], &q = polygon[i - 1], &r = polygon[i];
    const Integer determinant = Integer(p.x) * (Integer(q.y) * r.z - Integer(q.z) * r.y) +
                                Integer(p.y) * (Integer(q.z) * r.x - Integer(q.x) * r.z) +
                                Integer(p.z) * (Integer(q.x) * r.y - Integer(q.y) * r.x);
    sum += Rational(determinant, Integer(p.w) * q.w * r.w);
  }
  return sum;
}

Polytope Polytope::hull(const std::vector<std::array<int, 3>>& points) {
  Corners all;
  for (const auto& p : points) all.push_back({p[0], p[1], p[2], 1});
  std::map<LatticePlane, Corners> planes;
  for (const LatticePoint& p : all)
    for (const LatticePoint& q : all)
      for (const LatticePoint& r : all) {
        const LatticePlane plane = plane_through(p, q, r);
        if (plane.a == 0 && plane.b == 0 && plane.c == 0) continue;
        if (planes.contains(plane)) continue;
        if (std::any_of(all.begin(), all.end(),
                        [&](const LatticePoint& s) { return plane.side(s) > 0; }))
          continue;
        Corners& on = planes[plane];
        for (const LatticePoint& s : all)
          if (plane.side(s) == 0) on.push_back(s);
      }
  Polytope result;
  for (const auto& [plane, on] : planes) {
    if (planes.contains(turned(plane))) return {};
    result.facets_.push_back({plane, wrapped(plane, on)});
  }
  return result;
}

Polytope Polytope::clipped(const Polytope& other) const {
  if (is_empty() || other.is_empty()) return {};
  Polytope result;
  const auto add = [&](const Facet& facet, const std::vector<Facet>& by) {
    Corners left = clip(facet.corners, by);
    if (left.size() > 2) result.facets_.push_back({facet.plane, std::move(left)});
  };
  const auto has = [](const std::vector<Facet>& facets, const LatticePlane& plane) {
    return std::any_of(facets.begin(), facets.end(),
                       [&](const Facet& f) { return f.plane == plane; });
  };
  for (const Facet& facet : facets_) add(facet, other.facets_);
  for (const Facet& facet : other.facets_)
    if (!has(facets_, facet.plane)) add(facet, facets_);
  // Nothing but a common part of two facets: they lie in one plane, on different sides.
  for (const Facet& facet : result.facets_)
    if (has(result.facets_, turned(facet.plane))) {
      const LatticePlane plane = facet.plane;
      if (std::all_of(result.facets_.begin(), result.facets_.end(),
                      [&](const Facet& f) { return f.plane == plane || f.plane == turned(plane); }))
        return {};
    }
  return result;
}

Rational Polytope::volume() const {
  Rational sum = 0;
  for (const Facet& facet : facets_) sum += six_volumes(facet.corners);
  return sum / 6;
}

std::vector<LatticePoint> Polytope::corners() const {
  Corners all;
  for (const Facet& facet : facets_)
    all.insert(all.end(), facet.corners.begin(), facet.corners.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

PolygonMesh Polytope::mesh(std::uint64_t triangulated) const {
  PolygonMesh mesh;
  const Corners all = corners();
  for (const LatticePoint& p : all)
    mesh.positions.push_back({double(p.x), double(p.y), double(p.z)});
  const auto add = [&](const LatticePoint& p) {
    mesh.indices.push_back(
        static_cast<std::uint32_t>(std::lower_bound(all.begin(), all.end(), p) - all.begin()));
  };
  for (std::size_t i = 0; i < facets_.size(); ++i) {
    const Corners& corners = facets_[i].corners;
    if ((triangulated >> (i % 64) & 1) == 0) {
      for (const LatticePoint& p : corners) add(p);
      mesh.face_sizes.push_back(static_cast<std::uint32_t>(corners.size()));
      continue;
    }
    for (std::size_t k = 2; k < corners.size(); ++k) {
      for (const std::size_t c : {std::size_t{0}, k - 1, k}) add(corners[c]);
      mesh.face_sizes.push_back(3);
    }
  }
  return mesh;
}

}  // namespace sectile::test
