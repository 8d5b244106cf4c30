// Directions within the planes of faces.
#include "boolean/direction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "search/approximate.h"
#include "unit/boolean/phases.h"

namespace sectile {
namespace {

using namespace approximate;

// A cube of which a corner is missing: three of its faces are bent.
Solid notched_cube() {
  return boolean(test::lower_cube(), test::upper_cube(), Operation::subtract);
}

class CornersOfANotchedCube : public ::testing::Test {
 protected:
  CornersOfANotchedCube() : phases_(notched_cube(), test::upper_cube(), Operation::unite) {
    EXPECT_TRUE(patch().whole);
  }

  // Calls visit(half-edge, direction from its start) for all directions along planes of faces.
  template <class Visit>
  void for_each_direction(const Visit& visit) {
    for (const HalfEdgeId h : brep().half_edges())
      for_each_around(brep(), h, [&](HalfEdgeId i) {
        const PlaneId across = brep().plane_of(i);
        if (kernel().parallel(brep().plane_of(h), across)) return;
        visit(h, Direction{across, Sign::positive});
        visit(h, Direction{across, Sign::negative});
      });
  }

  const Patch& patch() { return phases_.w.patch[Operand::a]; }
  const Brep& brep() { return patch().brep; }
  const Kernel& kernel() { return phases_.w.tests(); }
  Vec3 position(VertexId v) { return phases_.w.geometry.position(brep().point_of(v)); }
  Vec3 normal(PlaneId s) {
    const PlaneValue& value = kernel().value(s);
    return {value.n[0], value.n[1], value.n[2]};
  }

  // From 0 to a full turn, counter-clockwise around n.
  static double angle(const Vec3& n, const Vec3& from, const Vec3& to) {
    const double turned = std::atan2(dot(n, cross(from, to)), std::sqrt(dot(n, n)) * dot(from, to));
    return turned < -1e-9 ? turned + 2 * std::numbers::pi : std::abs(turned);
  }

 private:
  test::Phases phases_;
};

TEST_F(CornersOfANotchedCube, TheSideOfItsEndTellsHowAnEdgeTurnsToADirection) {
  std::size_t turns = 0;
  for_each_direction([&](HalfEdgeId h, Direction d) {
    const Sign sign = turn_from(kernel(), brep().point_of(brep().to(h)), d);
    EXPECT_EQ(sign, turn(kernel(), brep().plane_of(h), direction_of(kernel(), patch(), h), d));
    turns += sign != Sign::zero;
  });
  EXPECT_GT(turns, 50u);
}

TEST_F(CornersOfANotchedCube, ADirectionIsWithinACornerIfItsAngleIs) {
  std::size_t inside = 0, outside = 0;
  for_each_direction([&](HalfEdgeId h, Direction d) {
    const Vec3 n = normal(brep().plane_of(h)), at = position(brep().from(h));
    const Vec3 first = position(brep().to(h)) - at,
               last = position(brep().from(brep().prev_of(h))) - at;
    const double sense = d.sense == Sign::positive ? 1 : -1;
    const Vec3 along = sense * cross(n, normal(d.across));
    const double opening = angle(n, first, last), there = angle(n, first, along);
    const Within expected = there < 1e-9                       ? Within::along_first
                            : std::abs(there - opening) < 1e-9 ? Within::along_last
                            : there < opening                  ? Within::inside
                                                               : Within::outside;
    EXPECT_EQ(within_corner(kernel(), patch(), h, d), expected);
    inside += expected == Within::inside;
    outside += expected == Within::outside;
  });
  EXPECT_GT(inside, 3u);  // in the bent corners
  EXPECT_GT(outside, 50u);
}

}  // namespace
}  // namespace sectile
