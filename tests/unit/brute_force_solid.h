// Is a triangle mesh the boundary of a solid? By definition, for every pair and every face, with
// integers that are never rounded: what the library's self-test is compared with.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "sectile/mesh.h"

namespace sectile::test {

/// A closed mesh of triangles with integer coordinates from -128 to 128; none without area.
class BruteForceSolid {
 public:
  explicit BruteForceSolid(const PolygonMesh& mesh) {
    for (const Vec3& p : mesh.positions)
      points_.push_back({static_cast<Int>(p.x), static_cast<Int>(p.y), static_cast<Int>(p.z)});
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
      triangles_.push_back(
          {points_[mesh.indices[i]], points_[mesh.indices[i + 1]], points_[mesh.indices[i + 2]]});
  }

  bool has_flat_triangle() const {
    for (const Triangle& t : triangles_)
      if (is_zero(normal(t))) return true;
    return false;
  }

  /// No two faces have an inner point in common, and there is no material on any outer side.
  bool is_legal() const {
    for (std::size_t i = 0; i < triangles_.size(); ++i)
      for (std::size_t j = i + 1; j < triangles_.size(); ++j)
        if (interiors_meet(i, j)) return false;
    for (std::size_t i = 0; i < triangles_.size(); ++i)
      if (winding_outside(i) != 0) return false;
    return !triangles_.empty();
  }

  bool interiors_meet(std::size_t i, std::size_t j) const {
    const Triangle &a = triangles_[i], &b = triangles_[j];
    const Vector na = normal(a), nb = normal(b), along = cross(na, nb);
    if (is_zero(along)) return dot(na, minus(b[0], a[0])) == 0 && overlap_in_plane(a, b, na);
    Fraction low_a, high_a, low_b, high_b;
    if (!chord(a, b, nb, along, low_a, high_a) || !chord(b, a, na, along, low_b, high_b))
      return false;
    return less(low_a, high_b) && less(low_b, high_a);
  }

 private:
  __extension__ using Int = __int128;
  using Vector = std::array<Int, 3>;
  using Triangle = std::array<Vector, 3>;
  struct Fraction {
    Int numerator = 0, denominator = 1;  // positive
  };

  static Vector minus(const Vector& a, const Vector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }
  static Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  static Int dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
  static bool is_zero(const Vector& a) { return a[0] == 0 && a[1] == 0 && a[2] == 0; }
  static Vector normal(const Triangle& t) { return cross(minus(t[1], t[0]), minus(t[2], t[0])); }
  static bool less(const Fraction& a, const Fraction& b) {
    return a.numerator * b.denominator < b.numerator * a.denominator;
  }

  // The part of the line of both planes within the interior of `a`.
  static bool chord(const Triangle& a, const Triangle& b, const Vector& nb, const Vector& along,
                    Fraction& low, Fraction& high) {
    Int side[3];
    bool above = false, below = false;
    for (std::size_t k = 0; k < 3; ++k) {
      side[k] = dot(nb, minus(a[k], b[0]));
      above |= side[k] > 0;
      below |= side[k] < 0;
    }
    if (!above || !below) return false;
    bool first = true;
    const auto add = [&](Int numerator, Int denominator) {
      if (denominator < 0) numerator = -numerator, denominator = -denominator;
      const Fraction f{numerator, denominator};
      if (first || less(f, low)) low = f;
      if (first || less(high, f)) high = f;
      first = false;
    };
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      if (side[k] == 0) add(dot(along, a[k]), 1);
      if ((side[k] > 0 && side[next] < 0) || (side[k] < 0 && side[next] > 0))
        add(side[k] * dot(along, a[next]) - side[next] * dot(along, a[k]), side[k] - side[next]);
    }
    return true;
  }

  static bool overlap_in_plane(const Triangle& a, const Triangle& b, const Vector& n) {
    return !separated(a, b, n) && !separated(b, a, normal(b));
  }
  static bool separated(const Triangle& a, const Triangle& b, const Vector& n) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector inwards = cross(n, minus(a[(k + 1) % 3], a[k]));
      bool apart = true;
      for (const Vector& p : b) apart &= dot(inwards, minus(p, a[k])) <= 0;
      if (apart) return true;
    }
    return false;
  }

  // Winding number beside an inner point, on the outer side, by a ray that meets no edge.
  int winding_outside(std::size_t i) const {
    const Triangle& t = triangles_[i];
    const Vector n = normal(t);
    std::mt19937 random(static_cast<unsigned>(i));
    for (;;) {
      const int u = 1 + static_cast<int>(random() % 5), v = 1 + static_cast<int>(random() % 5),
                w = 1 + static_cast<int>(random() % 5);
      Vector from, direction;
      for (std::size_t k = 0; k < 3; ++k) {
        from[k] = u * t[0][k] + v * t[1][k] + w * t[2][k];
        direction[k] = static_cast<int>(random() % 2001) - 1000;
      }
      if (dot(n, direction) <= 0) continue;
      int sum = 0;
      bool clear = true;
      for (std::size_t j = 0; j < triangles_.size() && clear; ++j)
        if (j != i) clear = add_crossing(triangles_[j], from, u + v + w, direction, sum);
      if (clear) return sum;
    }
  }

  // False if the ray meets the border of the triangle. `from` is scaled.
  static bool add_crossing(const Triangle& t, const Vector& from, Int scale,
                           const Vector& direction, int& sum) {
    Vector p[3];
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t axis = 0; axis < 3; ++axis) p[k][axis] = scale * t[k][axis] - from[axis];
    bool left = true, right = true, touched = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const Int turn = dot(direction, cross(p[k], p[(k + 1) % 3]));
      left &= turn >= 0;
      right &= turn <= 0;
      touched |= turn == 0;
    }
    if (!left && !right) return true;
    if (touched) return false;
    const Vector n = normal(t);
    const Int distance = dot(n, p[0]), slope = dot(n, direction);
    if (distance == 0) return false;
    if ((distance > 0) == (slope > 0)) sum += slope > 0 ? 1 : -1;
    return true;
  }

  std::vector<Vector> points_;
  std::vector<Triangle> triangles_;
};

}  // namespace sectile::test
