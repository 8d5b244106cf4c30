// Volumes and areas against rationals, or against what a shape's dimensions say.
#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include "geometry/kernel.h"
#include "import/measure.h"
#include "sectile/sectile.h"
#include "storage/solid_data.h"
#include "unit/rational.h"

namespace sectile::test {
namespace {

using Point = std::array<Rational, 3>;

Rational exactly(const Dyadic& number) {
  Rational sum;
  Dyadic rest = number;
  while (rest.sign() != Sign::zero) {
    const std::int64_t magnitude = rest.magnitude();
    const double digit = rest.scaled(-magnitude).nearest();
    const Integer power = Integer(1) << static_cast<unsigned>(std::abs(magnitude));
    sum += test::rational(digit) * (magnitude < 0 ? Rational(1, power) : Rational(power));
    rest -= Dyadic(digit).scaled(magnitude);
  }
  return sum;
}

Rational determinant(const Point& a, const Point& b, const Point& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

// The sum of the signed volumes of tetrahedra from the origin, with all coordinates exact.
Rational volume_in_rationals(const Solid& solid) {
  const SolidData& data = *solid.data();
  const Kernel kernel(data.geometry());
  std::vector<Point> at;
  for (const PointId p : data.brep().point) {
    const ExactPoint& e = kernel.exact(p);
    const Rational w = exactly(e.w);
    at.push_back({exactly(e.x[0]) / w, exactly(e.x[1]) / w, exactly(e.x[2]) / w});
  }
  Rational sum;
  for (const LoopId outer : data.brep().outer_loop)
    for (LoopId l = outer; l.valid(); l = data.brep().next_loop[l]) {
      std::vector<Point> corners;
      for_each_in_loop(data.brep(), l,
                       [&](HalfEdgeId h) { corners.push_back(at[data.brep().from(h).value()]); });
      for (std::size_t i = 2; i < corners.size(); ++i)
        sum += determinant(corners[0], corners[i - 1], corners[i]);
    }
  return sum / 6;
}

// Two units in the last place of the nearest double, or the double itself where doubles end.
void expect_right(double value, const Rational& expected) {
  const double right = nearest(expected);
  if (!std::isfinite(right)) {
    EXPECT_EQ(value, right);
    return;
  }
  double low = right, high = right;
  for (int i = 0; i < 2; ++i) {
    low = std::nextafter(low, -std::numeric_limits<double>::infinity());
    high = std::nextafter(high, std::numeric_limits<double>::infinity());
  }
  EXPECT_GE(value, low) << right;
  EXPECT_LE(value, high) << right;
}

Solid cube(double at, double edge) {
  return block({at, at, at}, {at + edge, at + edge, at + edge});
}

TEST(Volume, SmallCubesFarApart) {
  for (const double far : {0.0, 1e4, 1e6, 1e10, 1e15}) {
    const Solid both = boolean(cube(-1, 0.1), cube(far, 16), Operation::unite);
    expect_right(both.volume(), volume_in_rationals(both));
    EXPECT_NEAR(both.volume(), 0.1 * 0.1 * 0.1 + 4096, 1e-9);
  }
  for (const double far : {1e4, 1e6, 1e9}) {
    const Solid both = boolean(cube(0, 0.1), cube(far, 0.1), Operation::unite);
    expect_right(both.volume(), volume_in_rationals(both));
    EXPECT_GT(both.volume(), 0.0009);
  }
}

TEST(Volume, CubesOfAllSizes) {
  for (int exponent = -1074; exponent <= 1023; exponent += 9) {
    const double edge = std::ldexp(1.0, exponent);
    const Solid solid = block({0, 0, 0}, {edge, edge, edge});
    EXPECT_EQ(solid.volume(), std::ldexp(1.0, 3 * exponent)) << exponent;
    EXPECT_EQ(solid.area(), 6 * std::ldexp(1.0, 2 * exponent)) << exponent;
    const Solid beside = block({-edge, -edge, -edge}, {edge, 0.0, 0.75 * edge});
    expect_right(beside.volume(), volume_in_rationals(beside));
  }
}

TEST(Volume, NeedlesFromOneEndOfTheDoublesToTheOther) {
  const Solid needle = block({0, 0, 0}, {0x1p1000, 0x1p-500, 0x1p-500});
  EXPECT_EQ(needle.volume(), 1);
  EXPECT_EQ(needle.area(), 0x1p502);
  const Solid sheet = block({0, 0, 0}, {0x1p600, 0x1p600, 0x1p-1074});
  EXPECT_EQ(sheet.volume(), 0x1p126);
  EXPECT_EQ(sheet.area(), std::numeric_limits<double>::infinity());
}

TEST(Volume, ResultsWithImplicitPointsNearAndFar) {
  for (const double at : {0.0, 1.0, 1e3, 1e8, -3e12}) {
    const Transform there = Transform::translation({at, -at, at});
    const Solid a = transformed(cube(0, 16), there);
    const PolygonMesh tip{{{at + 1, -at + 1, at - 3},
                           {at + 9, -at + 2, at + 5},
                           {at + 3, -at + 11, at + 2},
                           {at + 2, -at + 3, at + 21}},
                          {3, 3, 3, 3},
                          {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}};
    const Solid b = Solid::from_mesh(tip);
    for (const Operation o : {Operation::unite, Operation::intersect, Operation::subtract}) {
      const Solid result = boolean(a, b, o);
      expect_right(result.volume(), volume_in_rationals(result));
    }
    const Rational common = volume_in_rationals(boolean(a, b, Operation::intersect));
    EXPECT_EQ(volume_in_rationals(boolean(a, b, Operation::unite)) + common,
              volume_in_rationals(a) + volume_in_rationals(b));
  }
}

// Less than the rounding of one coordinate of its corners.
TEST(Volume, ASliverBetweenNearlyEqualPlanes) {
  const Solid a = block({0, 0, 0}, {1, 1, 1});
  const HalfSpace first{1, 1e-9, 3.0000000001e-10, -0.75}, second{-1, -1e-9, -3e-10, 0.75};
  const Solid sliver = split(split(a, first).first, second).first;
  ASSERT_FALSE(sliver.is_empty());
  expect_right(sliver.volume(), volume_in_rationals(sliver));
}

TEST(Area, OfCutCubesIsThatOfTheirSections) {
  // A cube cut across its diagonal: the section is a hexagon with the area 3/4 √3 edge².
  for (const double edge : {1.0, 0x1p-300, 0x1p300, 0x1p-530, 0x1p510}) {
    const Solid half = split(block({0, 0, 0}, {edge, edge, edge}), {1, 1, 1, -1.5 * edge}).first;
    expect_right(half.area(),
                 (Rational(3) + rational(std::sqrt(3.0) * 0.75)) * rational(edge) * rational(edge));
    expect_right(half.volume(), rational(edge) * rational(edge) * rational(edge) / 2);
  }
}

TEST(Area, FarFromTheOrigin) {
  for (const double far : {1e4, 1e9, 1e15}) {
    const Solid there = block({far, far, far}, {far + 4, far + 8, far + 16});
    EXPECT_EQ(there.area(), 2 * (32 + 64 + 128));
    EXPECT_EQ(there.volume(), 512);
  }
}

// All corners are at two points of an edge that is cut at thirds: no number of bits tells the area.
TEST(Area, OfAFaceWithoutAnyIsAnError) {
  const Solid bar = block({0, 0, 0}, {2, 1, 1});
  const Solid cut = split(split(bar, {3, 1, 1, -7}).second, {3, 1, 1, -3}).first;
  const SolidData& data = *cut.data();
  const Kernel kernel(data.geometry());
  std::vector<PointId> on_edge;
  for (const PointId p : data.brep().point)
    if (const ExactPoint& at = kernel.exact(p); at.x[1] == at.w && at.x[2] == at.w)
      on_edge.push_back(p);
  ASSERT_EQ(on_edge.size(), 2u);
  Brep flat = data.brep();
  const HalfEdgeId first = flat.loop_half_edge[flat.outer_loop[FaceId(0)]];
  std::size_t corner = 0;
  for_each_in_loop(flat, flat.outer_loop[FaceId(0)], [&](HalfEdgeId h) {
    flat.point[flat.from(h)] = on_edge[h == first ? 0 : corner++ % 2];
  });
  const SomeFaces part[] = {{flat, data.geometry(), {FaceId(0)}}};
  EXPECT_THROW(exact_area(part), InternalError);
}

TEST(Measure, TheSameForAnyNumberOfThreads) {
  const Solid ball = sphere(1, 200, 100);
  const Solid both = boolean(ball, transformed(ball, Transform::translation({0.5, 0.25, 0.125})),
                             Operation::unite);
  const double volume = both.volume(), area = both.area();
  // Sums of rationals with so many denominators would take minutes.
  EXPECT_NEAR(volume, exact_volume(*both.data()), 2e-15);
  EXPECT_NEAR(area, exact_area(*both.data()), 8e-15);
  for (const int threads : {1, 2, 5}) {
    tbb::task_arena arena(threads);
    arena.execute([&] {
      EXPECT_EQ(both.volume(), volume);
      EXPECT_EQ(both.area(), area);
    });
  }
}

}  // namespace
}  // namespace sectile::test
