// Which triangles may be near another one: none that is may be missing, and of what lies beside it
// hardly any is looked at.
#include "rounding/flat_groups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <random>
#include <utility>
#include <vector>

#include "lattice_triangles.h"

namespace sectile {
namespace {

using namespace lattice;

Point minus(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
std::int64_t dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

bool apart_along(const Point& way, const Corners& s, const Corners& t) {
  const auto range = [&](const Corners& corners) {
    return std::minmax({dot(way, corners[0]), dot(way, corners[1]), dot(way, corners[2])});
  };
  const auto a = range(s), b = range(t);
  return a.second < b.first || b.second < a.first;
}

// By the separating axes of two convex sets, in integers.
bool are_apart(const Corners& s, const Corners& t) {
  std::vector<Point> in_s, in_t;
  for (std::size_t i = 0; i < 3; ++i) {
    in_s.push_back(minus(s[(i + 1) % 3], s[i]));
    in_t.push_back(minus(t[(i + 1) % 3], t[i]));
  }
  const Point n = cross(in_s[0], in_s[1]), m = cross(in_t[0], in_t[1]);
  std::vector<Point> ways{n, m};
  for (std::size_t i = 0; i < 3; ++i) {
    ways.push_back(cross(n, in_s[i]));
    ways.push_back(cross(m, in_t[i]));
    for (std::size_t j = 0; j < 3; ++j) ways.push_back(cross(in_s[i], in_t[j]));
  }
  return std::any_of(ways.begin(), ways.end(),
                     [&](const Point& way) { return apart_along(way, s, t); });
}

bool has_area(const Corners& t) {
  return cross(minus(t[1], t[0]), minus(t[2], t[0])) != Point{0, 0, 0};
}

// Triangles in integers, all of them scaled by one number.
struct Given {
  std::vector<Corners> corners;
  std::vector<std::uint32_t> ends;  // of faces
  double scale = 1, slack = 0;

  void end_face() { ends.push_back(static_cast<std::uint32_t>(corners.size())); }
  ViewedTriangle viewed(const Corners& of) const {
    PlacedTriangle placed;
    placed.vertex = {0, 1, 2};
    for (std::size_t k = 0; k < 3; ++k)
      placed.at[k] = {double(of[k][0]) * scale, double(of[k][1]) * scale, double(of[k][2]) * scale};
    return ViewedTriangle(placed, slack);
  }
  /// Others are looked at elsewhere: doubles do not tell that they have an area.
  bool is_clear(std::uint32_t i) const {
    const bool clear = viewed(corners[i]).view.clear();
    EXPECT_TRUE(clear || scale < 0x1p-300 || scale > 0x1p300);
    return clear;
  }
  FlatGroups groups(double extent) const {
    return FlatGroups([&](std::uint32_t i) { return viewed(corners[i]).placed; }, ends, slack,
                      extent * scale);
  }
};

using Pair = std::pair<std::uint32_t, std::uint32_t>;

template <class T>
std::vector<T> in_both(const std::vector<T>& some, const std::vector<T>& others) {
  std::vector<T> both;
  std::set_intersection(some.begin(), some.end(), others.begin(), others.end(),
                        std::back_inserter(both));
  return both;
}

constexpr std::uint32_t never = 0xFFFFFFFFu;

// Calls visit(group) for those that may meet a triangle; oriented boxes are asked beyond `many`.
template <class Visit>
void groups_near(const FlatGroups& groups, const ViewedTriangle& triangle, std::uint32_t many,
                 const Visit& visit) {
  groups.overlapping(
      box_around(triangle.placed, 0), many, [&] { return OrientedBox(triangle.placed.at); },
      groups.count(),
      [&](std::uint32_t g) {
        visit(g);
        return true;
      });
}

// The numbers of those that may be near, as given: each way of looking finds them.
std::vector<std::uint32_t> near(const FlatGroups& groups, const ViewedTriangle& triangle) {
  std::vector<std::uint32_t> result;
  for (const std::uint32_t many : {never, 3u, 0u}) {
    std::vector<std::uint32_t> found;
    const Box box = box_around(triangle.placed, 0);
    groups_near(groups, triangle, many, [&](std::uint32_t g) {
      groups.near(g, triangle.placed, box, [&](std::uint32_t place) {
        found.push_back(groups.number(place));
        return true;
      });
    });
    std::sort(found.begin(), found.end());
    result = many == never ? found : in_both(result, found);
  }
  return result;
}

// All pairs that may be near each other, with the lower number first: each way finds them.
std::vector<Pair> near_pairs(const FlatGroups& groups) {
  std::vector<Pair> result;
  for (const std::uint32_t many : {never, 0u}) {
    std::vector<Pair> found;
    for (std::uint32_t g = 0; g < groups.count(); ++g)
      groups.overlapping(
          groups.box(g), many, [&] { return groups.oriented(g); }, g + 1,
          [&](std::uint32_t h) {
            return groups.near_pairs(g, h, [&](std::uint32_t i, std::uint32_t j) {
              const auto [low, high] = std::minmax({groups.number(i), groups.number(j)});
              found.emplace_back(low, high);
              return true;
            });
          });
    std::sort(found.begin(), found.end());
    result = many == never ? found : in_both(result, found);
  }
  return result;
}

class Lattice : public RandomPoints {
 public:
  using RandomPoints::RandomPoints;

  Corners triangle(std::int64_t size) {
    for (;;)
      if (const Corners t{point(size), point(size), point(size)}; has_area(t)) return t;
  }
  // Of triangles in a plane through the origin.
  Corners in_plane(const Point& u, const Point& v, std::int64_t size) {
    const auto at = [&] {
      const std::int64_t a = number(size), b = number(size);
      return Point{a * u[0] + b * v[0], a * u[1] + b * v[1], a * u[2] + b * v[2]};
    };
    for (;;)
      if (const Corners t{at(), at(), at()}; has_area(t)) return t;
  }
};

// Faces of many triangles in planes aslant, and some that are alone.
Given random_faces(Lattice& lattice) {
  Given given;
  for (int face = 0; face < 6; ++face) {
    const Point u = lattice.point(3), v = lattice.point(3);
    if (cross(u, v) == Point{0, 0, 0}) continue;
    for (int i = 0; i < 12 * face; ++i) given.corners.push_back(lattice.in_plane(u, v, 8));
    if (face > 0) given.end_face();
  }
  for (int i = 0; i < 20; ++i) {
    given.corners.push_back(lattice.triangle(20));
    given.end_face();
  }
  return given;
}

TEST(FlatGroups, MissNothingThatMeets) {
  for (const double scale : {1.0, 0x1p-20, 0x1p-360, 0x1p-520, 0x1p340, 0x1p500})
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      Lattice lattice(seed);
      Given given = random_faces(lattice);
      given.scale = scale;
      const FlatGroups groups = given.groups(120);
      ASSERT_EQ(groups.size(), given.corners.size());
      for (int i = 0; i < 100; ++i) {
        const Corners t = lattice.triangle(15);
        const std::vector<std::uint32_t> found = near(groups, given.viewed(t));
        for (std::uint32_t s = 0; s < given.corners.size(); ++s) {
          if (std::binary_search(found.begin(), found.end(), s) || !given.is_clear(s)) continue;
          EXPECT_TRUE(are_apart(given.corners[s], t)) << s << ", seed " << seed;
        }
      }
    }
}

// Two units away, and corners may have moved by up to one each.
TEST(FlatGroups, MissNothingThatMayHaveMet) {
  Lattice lattice(5);
  Given given;
  for (int i = 0; i < 40; ++i) given.corners.push_back(lattice.in_plane({1, 0, 0}, {0, 1, 0}, 50));
  given.end_face();
  const auto found_above = [&](std::int64_t height, double slack) {
    given.slack = slack;
    return !near(given.groups(200),
                 given.viewed({{{-40, -40, height}, {40, -30, height + 9}, {0, 45, height + 5}}}))
                .empty();
  };
  EXPECT_TRUE(found_above(2, 1));
  EXPECT_TRUE(found_above(2, 1.5));
  EXPECT_FALSE(found_above(2, 0.9));
  EXPECT_FALSE(found_above(2, 0));
  EXPECT_TRUE(found_above(0, 0));
}

// Of what lies in its plane, doubles compute that it is beside it by some of their last digits, and
// of coordinates of any size.
TEST(FlatGroups, MissNothingThatTouchesATriangleWithin) {
  std::mt19937 random(7);
  for (const double scale : {1.0, 0x1p-345, 0x1p-350, 0x1p300}) {
    int seen = 0;
    const auto number = [&] {
      return scale * double(std::uniform_real_distribution<float>(-1, 1)(random));
    };
    for (int i = 0; i < 3000; ++i) {
      PlacedTriangle s, t;
      for (Vec3& p : s.at) p = {number(), number(), number()};
      const auto& [p, q, r] = s.at;
      const auto middle = [](double a, double b, double c) { return ((a + b) / 2 + c) / 2; };
      const Vec3 within{middle(p.x, q.x, r.x), middle(p.y, q.y, r.y), middle(p.z, q.z, r.z)};
      const auto normal = ViewedTriangle(s, 0).plane.normal();
      const double size = std::hypot(normal[0], normal[1], normal[2]);
      if (size == 0) continue;
      const auto beyond = [&](double far) {
        far *= scale;
        return Vec3{within.x + far * (normal[0] / size), within.y + far * (normal[1] / size),
                    within.z + far * (normal[2] / size)};
      };
      const double side = i % 2 == 0 ? 1 : -1;
      t.at = {within, beyond(0.25 * side), beyond(0.5 * side)};
      const FlatGroups groups([&](std::uint32_t) { return s; }, {1}, 0, 4 * scale);
      if (!groups.triangle(0).view.clear()) continue;  // of very small coordinates
      ++seen;
      ASSERT_EQ(near(groups, ViewedTriangle(t, 0)).size(), 1u) << i << ", scale " << scale;
    }
    EXPECT_GT(seen, scale < 0x1p-340 ? 100 : 2900) << "scale " << scale;
  }
}

// A plate aslant that was cut into 1,000 slivers from one of its corners.
Given fan_of_slivers() {
  Given given;
  const auto at = [](std::int64_t a, std::int64_t b) { return Point{a + b, 2 * a - b, a}; };
  for (std::int64_t i = 0; i < 1000; ++i)
    given.corners.push_back({at(0, 0), at(3000, 3 * i), at(3000, 3 * i + 3)});
  given.end_face();
  return given;
}

TEST(FlatGroups, NothingOfAPlateIsNearWhatIsBesideIt) {
  const Given given = fan_of_slivers();
  const FlatGroups groups = given.groups(10'000);
  // In its box, two units above or below it.
  for (const std::int64_t side : {-2, 2}) {
    const Corners t{
        {{3000, 1500, 1500 + side}, {3060, 1560, 1540 + side}, {3003, 1500, 1501 + side}}};
    ASSERT_TRUE(std::all_of(given.corners.begin(), given.corners.end(),
                            [&](const Corners& s) { return are_apart(s, t); }));
    EXPECT_TRUE(near(groups, given.viewed(t)).empty());
  }
  const auto count_near = [&](std::int64_t height) {
    const Corners t{{{3000, 1500, height}, {3003, 1500, height + 1}, {3000, 1503, height + 2}}};
    const ViewedTriangle viewed = given.viewed(t);
    std::size_t count = 0;
    groups_near(groups, viewed, never, [&](std::uint32_t g) {
      count += groups.slab(g).always_clear_of(box_around(viewed.placed, 0)) ? 0 : 1;
    });
    return count;
  };
  EXPECT_EQ(count_near(1503), 0u);
  EXPECT_EQ(count_near(1497), 0u);
  EXPECT_GT(count_near(1500), 0u);
}

TEST(FlatGroups, FewOfALargeFaceAreNearWhatTouchesIt) {
  const Given given = fan_of_slivers();
  const FlatGroups groups = given.groups(10'000);
  // Across the far edge of sliver 500.
  const Corners t{{{4500, 4500, 3000}, {4503, 4497, 3001}, {4500, 4500, 3004}}};
  const std::vector<std::uint32_t> found = near(groups, given.viewed(t));
  EXPECT_TRUE(std::binary_search(found.begin(), found.end(), 500u));
  EXPECT_LT(found.size(), 100u);
}

TEST(FlatGroups, MissNoPairThatMeets) {
  for (const double scale : {1.0, 0x1p-520, 0x1p500})
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      Lattice lattice(seed);
      Given given = random_faces(lattice);
      given.scale = scale;
      const std::vector<Pair> found = near_pairs(given.groups(120));
      EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());  // each comes once
      for (std::uint32_t t = 0; t < given.corners.size(); ++t)
        for (std::uint32_t s = 0; s < t; ++s) {
          if (std::binary_search(found.begin(), found.end(), Pair(s, t))) continue;
          if (!given.is_clear(s) || !given.is_clear(t)) continue;
          EXPECT_TRUE(are_apart(given.corners[s], given.corners[t])) << s << ' ' << t;
        }
    }
}

// Two plates, two units apart, whose boxes overlap, as they lie aslant.
TEST(FlatGroups, MissNoPairThatMayHaveMet) {
  Lattice lattice(6);
  Given given;
  for (const std::int64_t height : {0, 2}) {
    for (int i = 0; i < 20; ++i) {
      given.corners.push_back(lattice.in_plane({1, 0, 1}, {0, 1, 1}, 20));
      for (Point& p : given.corners.back()) p[2] += height;
    }
    given.end_face();
  }
  const auto pairs_between = [&](double slack) {
    given.slack = slack;
    const std::vector<Pair> pairs = near_pairs(given.groups(100));
    return std::count_if(pairs.begin(), pairs.end(),
                         [](const Pair& p) { return p.first < 20 && p.second >= 20; });
  };
  EXPECT_EQ(pairs_between(0), 0);
  EXPECT_EQ(pairs_between(0.3), 0);
  EXPECT_GT(pairs_between(1), 0);
}

// Boxes of all needles overlap.
TEST(FlatGroups, FewNeedlesAreNearOneBetweenThem) {
  Given given;
  const auto needle = [](std::int64_t i) {
    return Corners{{{i, 0, 0}, {i + 1, 0, 1}, {i + 3000, 3000, 2000}}};
  };
  for (std::int64_t i = 0; i < 500; ++i) {
    given.corners.push_back(needle(4 * i));
    given.end_face();
  }
  const FlatGroups groups = given.groups(10'000);
  const auto count_near = [&](std::uint32_t many) {
    std::size_t count = 0;
    groups_near(groups, given.viewed(needle(1002)), many, [&](std::uint32_t) { ++count; });
    return count;
  };
  EXPECT_EQ(count_near(never), 500u);
  EXPECT_LT(count_near(20), 60u);
  EXPECT_LT(count_near(0), 20u);
}

TEST(FlatGroups, PiecesBesideEachOtherInTheirFaceAreNoPairs) {
  Given given;
  for (std::int64_t i = 0; i < 40; ++i)
    given.corners.push_back({{{9 * i, 0, 0}, {9 * i + 5, 0, 0}, {9 * i, 5, 0}}});
  given.end_face();
  EXPECT_TRUE(near_pairs(given.groups(400)).empty());
}

TEST(FlatGroups, WhatHasNoAreaIsNearNothing) {
  Given given;
  given.corners = {{{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}}},
                   {{{0, 0, 0}, {4, 4, 0}, {9, 9, 0}}},
                   {{{1, 1, 0}, {8, 1, 0}, {1, 8, 0}}}};
  given.end_face();
  const FlatGroups groups = given.groups(20);
  ASSERT_EQ(groups.size(), 3u);
  EXPECT_FALSE(groups.triangle(1).view.clear());
  EXPECT_EQ(near_pairs(groups), std::vector<Pair>{Pair(0, 2)});
  const ViewedTriangle above = given.viewed({{{0, 0, 0}, {9, 0, 1}, {0, 9, 1}}});
  EXPECT_EQ(near(groups, above), (std::vector<std::uint32_t>{0, 2}));
}

TEST(FlatGroups, StopWhereTheyAreTold) {
  Given given;
  for (int i = 0; i < 10; ++i) given.corners.push_back({{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}}});
  given.end_face();
  const FlatGroups groups = given.groups(20);
  const ViewedTriangle t = given.viewed({{{0, 0, 0}, {9, 0, 1}, {0, 9, 1}}});
  int visited = 0;
  EXPECT_FALSE(groups.near(0, t.placed, box_around(t.placed, 0),
                           [&](std::uint32_t) { return ++visited < 3; }));
  EXPECT_EQ(visited, 3);
  EXPECT_FALSE(
      groups.near_pairs(0, 0, [&](std::uint32_t, std::uint32_t) { return ++visited < 8; }));
  EXPECT_EQ(visited, 8);
}

}  // namespace
}  // namespace sectile
