// Convex polytopes with integer corners and all that clipping makes of them, in exact integers:
// what operations on lattice solids should give, found without the library's help.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sectile/mesh.h"
#include "unit/rational.h"

namespace sectile::test {

/// The point (x, y, z) / w with w > 0 and without a common divisor, so that equal points are equal.
struct LatticePoint {
  std::int64_t x = 0, y = 0, z = 0, w = 1;
  static LatticePoint reduced(std::int64_t x, std::int64_t y, std::int64_t z, std::int64_t w);
  friend auto operator<=>(const LatticePoint&, const LatticePoint&) = default;
};

/// a·x + b·y + c·z = d; the normal (a, b, c) points out of the material.
struct LatticePlane {
  std::int64_t a = 0, b = 0, c = 0, d = 0;
  /// Positive outside.
  std::int64_t side(const LatticePoint& p) const { return a * p.x + b * p.y + c * p.z - d * p.w; }
  friend auto operator<=>(const LatticePlane&, const LatticePlane&) = default;
};

/// Six times the signed volume between the origin and a polygon, which may be any closed line.
Rational six_volumes(const std::vector<LatticePoint>& polygon);

class Polytope {
 public:
  struct Facet {
    LatticePlane plane;
    std::vector<LatticePoint> corners;  ///< counter-clockwise from outside
  };

  /// The convex hull; no facets if the points lie in one plane.
  static Polytope hull(const std::vector<std::array<int, 3>>& points);
  /// Of the same planes, the points within all those of `other`, too.
  Polytope clipped(const Polytope& other) const;

  bool is_empty() const { return facets_.empty(); }
  const std::vector<Facet>& facets() const { return facets_; }
  Rational volume() const;
  std::vector<LatticePoint> corners() const;

  /// A mesh of whole facets or, where bit i of `triangulated` is set, a fan of triangles.
  PolygonMesh mesh(std::uint64_t triangulated) const;

 private:
  std::vector<Facet> facets_;
};

}  // namespace sectile::test
