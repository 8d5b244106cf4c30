// A surface, part by part, and the pairs of its triangles that meet as they must not.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "selftest/self_test.h"
#include "selftest/triangle_pair.h"

namespace sectile::test {

class ContactsOfASurface {
 public:
  using Pair = std::array<std::uint32_t, 3>;  // and the kind

  /// A closed surface of points, counter-clockwise, seen from outside.
  void add(const std::vector<std::array<PointId, 3>>& triangles, bool inside_out) {
    const std::size_t begin = surface_.size();
    for (auto [a, b, c] : triangles) {
      if (inside_out) std::swap(b, c);
      surface_.corners.push_back({a, b, c});
      surface_.plane.push_back(geometry_.add_plane(PlaneDefinition::through(a, b, c)));
      surface_.face.push_back(static_cast<std::uint32_t>(surface_.face.size()));
    }
    find_mates(begin);
  }
  /// One for each place.
  PointId point(const Vec3& p) {
    const auto [known, is_new] = points_.try_emplace({p.x, p.y, p.z});
    if (is_new) known->second = geometry_.add_point(p);
    return known->second;
  }

  /// Where products of coordinates are doubles.
  bool has_no_area(const std::array<PointId, 3>& triangle) const {
    const Vec3 &p = geometry_.position(triangle[0]), &q = geometry_.position(triangle[1]),
               &r = geometry_.position(triangle[2]);
    const double x[] = {q.x - p.x, q.y - p.y, q.z - p.z}, y[] = {r.x - p.x, r.y - p.y, r.z - p.z};
    return x[0] * y[1] == x[1] * y[0] && x[1] * y[2] == x[2] * y[1] && x[2] * y[0] == x[0] * y[2];
  }

  std::vector<Pair> found() const {
    std::vector<Pair> pairs;
    for (const SelfContact& c : self_contacts(surface_, Kernel(geometry_)))
      pairs.push_back(as_pair(c));
    return pairs;
  }
  /// By a look at each two.
  std::vector<Pair> expected() const {
    std::vector<Pair> pairs;
    const Kernel kernel(geometry_);
    const TrianglePairs test(surface_, kernel);
    for (std::uint32_t s = 0; s < surface_.size(); ++s)
      for (std::uint32_t t = s + 1; t < surface_.size(); ++t)
        if (const auto contact = test.test(s, t)) pairs.push_back(as_pair(*contact));
    return pairs;
  }

 private:
  static Pair as_pair(const SelfContact& c) {
    return {c.first, c.second, static_cast<std::uint32_t>(c.kind)};
  }
  void find_mates(std::size_t begin) {
    const auto edge = [&](std::size_t t, std::size_t k) {
      return std::pair(surface_.corners[t][k], surface_.corners[t][(k + 1) % 3]);
    };
    surface_.mate.resize(surface_.size());
    for (std::size_t s = begin; s < surface_.size(); ++s)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t t = begin; t < surface_.size(); ++t)
          for (std::size_t k = 0; k < 3; ++k)
            if (edge(s, j) == std::pair(edge(t, k).second, edge(t, k).first))
              surface_.mate[s][j] = static_cast<std::uint32_t>(t);
  }

  Geometry geometry_;
  std::map<std::array<double, 3>, PointId> points_;
  TriangleSurface surface_;
};

}  // namespace sectile::test
