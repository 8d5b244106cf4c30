// Is a mesh of triangles, as it stands in a file, a legal solid? Exact, and nothing of the library
// is asked: long doubles with an error bound, then rationals.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "sectile/mesh.h"
#include "unit/rational.h"

namespace sectile::test {

class ExactMeshChecker {
 public:
  explicit ExactMeshChecker(const PolygonMesh& mesh) : mesh_(mesh) {}

  /// What is wrong, in words; empty if nothing is.
  std::string verdict() {
    read();
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      if (is_flat(t)) return "triangle " + std::to_string(t) + " has no area";
    if (!is_closed()) return "the surface is not closed or not oriented";
    if (const std::string pair = meeting_pair(); !pair.empty()) return pair;
    return wrong_side();
  }

 private:
  using Triangle = std::array<std::uint32_t, 3>;
  using RationalPoint = std::array<Rational, 3>;

  const Vec3& at(std::size_t t, std::size_t k) const { return points_[triangles_[t][k]]; }

  void read() {
    std::map<std::array<double, 3>, std::uint32_t> number;
    std::vector<std::uint32_t> of_position;
    for (const Vec3& p : mesh_.positions) {
      const auto [place, is_new] = number.try_emplace({p.x + 0.0, p.y + 0.0, p.z + 0.0},
                                                      static_cast<std::uint32_t>(points_.size()));
      if (is_new) points_.push_back(p);
      of_position.push_back(place->second);
    }
    for (std::size_t i = 0; i + 2 < mesh_.indices.size(); i += 3)
      triangles_.push_back({of_position[mesh_.indices[i]], of_position[mesh_.indices[i + 1]],
                            of_position[mesh_.indices[i + 2]]});
  }

  static RationalPoint exact(const Vec3& p) {
    return {rational(p.x), rational(p.y), rational(p.z)};
  }
  static RationalPoint minus(const RationalPoint& a, const RationalPoint& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }
  static RationalPoint cross(const RationalPoint& a, const RationalPoint& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  static Rational dot(const RationalPoint& a, const RationalPoint& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
  RationalPoint normal(std::size_t t) const {
    const RationalPoint a = exact(at(t, 0));
    return cross(minus(exact(at(t, 1)), a), minus(exact(at(t, 2)), a));
  }

  bool is_flat(std::size_t t) const {
    using Real = long double;
    const Vec3 &a = at(t, 0), &b = at(t, 1), &c = at(t, 2);
    const Real u[3] = {Real(b.x) - a.x, Real(b.y) - a.y, Real(b.z) - a.z};
    const Real v[3] = {Real(c.x) - a.x, Real(c.y) - a.y, Real(c.z) - a.z};
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      const Real left = u[i] * v[j], right = u[j] * v[i];
      if (std::abs(left - right) > (std::abs(left) + std::abs(right)) * 0x1p-58L + 0x1p-16000L)
        return false;
    }
    const RationalPoint n = normal(t);
    return n[0] == 0 && n[1] == 0 && n[2] == 0;
  }

  bool is_closed() const {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sum;
    for (const Triangle& t : triangles_)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = t[k], b = t[(k + 1) % 3];
        if (a == b) return false;
        sum[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
      }
    return std::all_of(sum.begin(), sum.end(), [](const auto& edge) { return edge.second == 0; });
  }

  // On which side of triangle t is a point?
  int side(std::size_t t, const Vec3& p) const {
    const Vec3 &a = at(t, 0), &b = at(t, 1), &c = at(t, 2);
    if (p == a || p == b || p == c) return 0;
    using Real = long double;
    const Real u[3] = {Real(b.x) - a.x, Real(b.y) - a.y, Real(b.z) - a.z};
    const Real v[3] = {Real(c.x) - a.x, Real(c.y) - a.y, Real(c.z) - a.z};
    const Real w[3] = {Real(p.x) - a.x, Real(p.y) - a.y, Real(p.z) - a.z};
    Real sum = 0, size = 0;
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      sum += w[k] * (u[i] * v[j] - u[j] * v[i]);
      size += std::abs(w[k]) * (std::abs(u[i] * v[j]) + std::abs(u[j] * v[i]));
    }
    if (std::abs(sum) > size * 0x1p-58L + 0x1p-16000L) return sum > 0 ? 1 : -1;
    const Rational value = dot(normal(t), minus(exact(p), exact(a)));
    return value > 0 ? 1 : value < 0 ? -1 : 0;
  }

  std::string meeting_pair() const {
    struct Item {
      double low[3], high[3];
      std::size_t triangle;
    };
    std::vector<Item> items;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      Item item{{0, 0, 0}, {0, 0, 0}, t};
      for (std::size_t k = 0; k < 3; ++k) {
        const double p[3] = {at(t, k).x, at(t, k).y, at(t, k).z};
        for (int i = 0; i < 3; ++i) {
          item.low[i] = k == 0 ? p[i] : std::min(item.low[i], p[i]);
          item.high[i] = k == 0 ? p[i] : std::max(item.high[i], p[i]);
        }
      }
      items.push_back(item);
    }
    std::sort(items.begin(), items.end(),
              [](const Item& a, const Item& b) { return a.low[0] < b.low[0]; });
    for (std::size_t i = 0; i < items.size(); ++i)
      for (std::size_t j = i + 1; j < items.size() && items[j].low[0] <= items[i].high[0]; ++j) {
        const Item &a = items[i], &b = items[j];
        if (a.low[1] > b.high[1] || b.low[1] > a.high[1] || a.low[2] > b.high[2] ||
            b.low[2] > a.high[2])
          continue;
        if (interiors_meet(a.triangle, b.triangle))
          return "triangles " + std::to_string(a.triangle) + " and " + std::to_string(b.triangle) +
                 " meet";
      }
    return {};
  }

  bool interiors_meet(std::size_t s, std::size_t t) const {
    int of_t[3], of_s[3];
    bool crosses = false, flat = true;
    const auto look = [&](std::size_t plane, std::size_t other, int(&sides)[3]) {
      bool above = false, below = false;
      flat = true;
      for (std::size_t k = 0; k < 3; ++k) {
        sides[k] = side(plane, at(other, k));
        above |= sides[k] > 0;
        below |= sides[k] < 0;
        flat &= sides[k] == 0;
      }
      crosses = above && below;
    };
    look(s, t, of_t);
    if (flat) return overlap_in_plane(s, t);
    if (!crosses) return false;
    look(t, s, of_s);
    if (!crosses) return false;
    const RationalPoint along = cross(normal(s), normal(t));
    const auto [low_s, high_s] = chord(s, t, along);
    const auto [low_t, high_t] = chord(t, s, along);
    return low_s < high_t && low_t < high_s;
  }

  // Where triangle t meets the plane of another one, along the line of both planes.
  std::pair<Rational, Rational> chord(std::size_t t, std::size_t other,
                                      const RationalPoint& along) const {
    const RationalPoint n = normal(other), o = exact(at(other, 0));
    Rational height[3], place[3];
    for (std::size_t k = 0; k < 3; ++k) {
      height[k] = dot(n, minus(exact(at(t, k)), o));
      place[k] = dot(along, exact(at(t, k)));
    }
    std::vector<Rational> ends;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t j = (k + 1) % 3;
      if (height[k] == 0) ends.push_back(place[k]);
      if (height[k] * height[j] < 0)
        ends.push_back((height[k] * place[j] - height[j] * place[k]) / (height[k] - height[j]));
    }
    if (ends[1] < ends[0]) std::swap(ends[0], ends[1]);
    return {ends[0], ends[1]};
  }

  bool overlap_in_plane(std::size_t s, std::size_t t) const {
    return !separated(s, t) && !separated(t, s);
  }
  bool separated(std::size_t s, std::size_t t) const {
    const RationalPoint n = normal(s);
    for (std::size_t k = 0; k < 3; ++k) {
      const RationalPoint from = exact(at(s, k));
      const RationalPoint inwards = cross(n, minus(exact(at(s, (k + 1) % 3)), from));
      bool apart = true;
      for (std::size_t j = 0; j < 3; ++j) apart &= dot(inwards, minus(exact(at(t, j)), from)) <= 0;
      if (apart) return true;
    }
    return false;
  }

  // Beside some triangle of each part, and beside some at edges of several wedges, there must be no
  // material on the outer side.
  std::string wrong_side() const {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> at_edge;
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = triangles_[t][k], b = triangles_[t][(k + 1) % 3];
        at_edge[{std::min(a, b), std::max(a, b)}].push_back(t);
      }
    std::vector<std::size_t> part(triangles_.size());
    for (std::size_t t = 0; t < part.size(); ++t) part[t] = t;
    const auto root = [&](std::size_t t) {
      while (part[t] != t) t = part[t] = part[part[t]];
      return t;
    };
    std::vector<std::size_t> samples;
    for (const auto& [edge, around] : at_edge) {
      for (const std::size_t t : around) part[root(t)] = root(around[0]);
      if (around.size() > 2 && samples.size() < 8)
        samples.insert(samples.end(), around.begin(), around.end());
    }
    for (std::size_t t = 0; t < part.size(); ++t)
      if (root(t) == t) samples.push_back(t);
    for (const std::size_t t : samples)
      if (const int winding = winding_outside(t); winding != 0)
        return "outside of triangle " + std::to_string(t) + " the winding number is " +
               std::to_string(winding);
    return {};
  }

  int winding_outside(std::size_t t) const {
    std::mt19937 random(static_cast<unsigned>(t));
    const RationalPoint n = normal(t);
    for (;;) {
      RationalPoint from{0, 0, 0}, direction;
      int weights = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const int weight = 1 + static_cast<int>(random() % 9);
        weights += weight;
        const RationalPoint p = exact(at(t, k));
        for (std::size_t i = 0; i < 3; ++i) from[i] += weight * p[i];
        direction[k] = static_cast<int>(random() % 2001) - 1000;
      }
      for (Rational& x : from) x /= weights;
      if (dot(n, direction) <= 0) continue;
      int sum = 0;
      bool clear = true;
      for (std::size_t s = 0; s < triangles_.size() && clear; ++s)
        if (s != t) clear = add_crossing(s, from, direction, sum);
      if (clear) return sum;
    }
  }

  // False if the ray meets the border of the triangle.
  bool add_crossing(std::size_t s, const RationalPoint& from, const RationalPoint& direction,
                    int& sum) const {
    RationalPoint p[3];
    for (std::size_t k = 0; k < 3; ++k) p[k] = minus(exact(at(s, k)), from);
    bool left = true, right = true, touched = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational turn = dot(direction, cross(p[k], p[(k + 1) % 3]));
      left &= turn >= 0;
      right &= turn <= 0;
      touched |= turn == 0;
    }
    if (!left && !right) return true;
    if (touched) return false;
    const RationalPoint n = normal(s);
    const Rational distance = dot(n, p[0]), slope = dot(n, direction);
    if (distance == 0) return false;
    if ((distance > 0) == (slope > 0)) sum += slope > 0 ? 1 : -1;
    return true;
  }

  const PolygonMesh& mesh_;
  std::vector<Vec3> points_;
  std::vector<Triangle> triangles_;
};

}  // namespace sectile::test
