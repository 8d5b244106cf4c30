// Whole numbers within thin cones: told by whole numbers, and compared with all that are near.
#include "rounding/numbers_in_cone.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <vector>

#include "cases.h"

namespace sectile {
namespace {

using Way = std::array<long, 3>;
constexpr long none = std::numeric_limits<long>::max();

long dot(const Way& a, const Way& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Way cross(const Way& a, const Way& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
long size(const Way& a) {
  return std::max({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])});
}
Vec3 of_length_one(const Way& a) {
  const double x = static_cast<double>(a[0]), y = static_cast<double>(a[1]),
               z = static_cast<double>(a[2]), length = std::hypot(x, y, z);
  return {x / length, y / length, z / length};
}

// All between two half-planes along an edge.
struct Wedge {
  std::vector<Way> inward;
  Way amid;

  bool contains(const Way& a) const {
    return std::all_of(inward.begin(), inward.end(), [&](const Way& n) { return dot(n, a) > 0; });
  }
  ThinCone seen_from(const Vec3& tip) const {
    ThinCone cone{tip, {0, 0, 0}, {}, of_length_one(amid)};
    for (const Way& n : inward) cone.inward.push_back(of_length_one(n));
    return cone;
  }
};

Wedge thin_wedge(std::mt19937& random) {
  const auto number = [&](long most) {
    return static_cast<long>(random() % static_cast<unsigned long>(2 * most + 1)) - most;
  };
  for (;;) {
    const Way edge{number(9), number(9), number(9)}, first{number(999), number(999), number(999)};
    const Way last{first[0] + number(40), first[1] + number(40), first[2] + number(40)};
    Way below = cross(edge, first), above = cross(last, edge);
    if (dot(below, last) < 0) below = cross(first, edge), above = cross(edge, last);
    const Wedge wedge{{below, above}, {first[0] + last[0], first[1] + last[1], first[2] + last[2]}};
    if (wedge.contains(wedge.amid)) return wedge;
  }
}

// In the greatest coordinate; of all that is no farther.
long nearest_of_all(const Wedge& wedge, long most) {
  long nearest = none;
  for (long x = -most; x <= most; ++x)
    for (long y = -most; y <= most; ++y)
      for (long z = -most; z <= most; ++z)
        if (size({x, y, z}) < nearest && wedge.contains({x, y, z})) nearest = size({x, y, z});
  return nearest;
}

// Doubles do not tell what is on a plane from what is beside it.
long nearest_of_found(const Wedge& wedge, const Way& tip, double far) {
  Rounding rounding;
  rounding.numbers = Rounding::Numbers::grid;
  const Vec3 at{static_cast<double>(tip[0]), static_cast<double>(tip[1]),
                static_cast<double>(tip[2])};
  long nearest = none;
  for (const Vec3& p : numbers_in_cone(RoundingGrid(rounding), wedge.seen_from(at), far, 1)) {
    const Way way{std::lround(p.x) - tip[0], std::lround(p.y) - tip[1], std::lround(p.z) - tip[2]};
    EXPECT_LE(static_cast<double>(size(way)), 4 * far);
    for (const Way& n : wedge.inward) EXPECT_GE(dot(n, way), 0);
    if (wedge.contains(way)) nearest = std::min(nearest, size(way));
  }
  return nearest;
}

TEST(NumbersInCone, AreInsideAndAboutAsNearAsAny) {
  for (int seed = 0; seed < cases(300); ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(static_cast<unsigned>(seed));
    const Wedge wedge = thin_wedge(random);
    long found = none;
    for (double far = 1; found == none && far < 1e6; far *= 2)
      found = nearest_of_found(wedge, {1000, -70, 12}, far);
    ASSERT_NE(found, none);
    EXPECT_LE(found, 2 * nearest_of_all(wedge, found));
  }
}

// As thin as one part in a million: where the half-planes are a step apart.
TEST(NumbersInCone, AreFoundInTheThinnestCones) {
  for (const long far : {1000L, 1000000L}) {
    const Wedge wedge{{{-1, far, 0}, {1, 1 - far, 0}}, {2 * far - 1, 2, 0}};
    ASSERT_TRUE(wedge.contains(wedge.amid));
    EXPECT_EQ(nearest_of_found(wedge, {5, 7, 9}, static_cast<double>(far)), 2 * far - 1);
  }
}

TEST(NumbersInCone, ThereAreNoneNearWhereThereAreNone) {
  const Wedge wedge{{{-1, 1000, 0}, {1, -999, 0}}, {1999, 2, 0}};
  EXPECT_EQ(nearest_of_found(wedge, {5, 7, 9}, 20), none);
}

}  // namespace
}  // namespace sectile
