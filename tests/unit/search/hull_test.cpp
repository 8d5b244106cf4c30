// What is told apart is apart, whatever its place, size and shape; and thin slanted faces are told
// apart where their boxes overlap.
#include "search/hull.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "search/face_slab.h"
#include "search/oriented_box.h"

namespace sectile {
namespace {

using Points = std::vector<Vec3>;

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  int upto(int most) { return std::uniform_int_distribution<int>(-most, most)(engine_); }
  Vec3 lattice_point(int most) {
    return {double(upto(most)), double(upto(most)), double(upto(most))};
  }

 private:
  std::mt19937 engine_;
};

// All coordinates are multiples of `unit`: sums and halves of them are exact.
Points triangle(Random& random, const Vec3& through, double unit, int thin) {
  // The point is the middle of a median, and so in the triangle.
  const auto step = [&] {
    const Vec3 p = random.lattice_point(1000);
    return Vec3{p.x * unit, p.y * unit, p.z * unit};
  };
  const Vec3 u = step(), v = step();
  const double s = 1.0 / (1 << thin);
  const auto at = [&](double x, double y) {
    return Vec3{through.x + x * u.x + y * s * v.x, through.y + x * u.y + y * s * v.y,
                through.z + x * u.z + y * s * v.z};
  };
  return {at(1, 1), at(1, -1), at(-1, 0)};
}

Points moved(Points points, const Vec3& by) {
  for (Vec3& p : points) p = {p.x + by.x, p.y + by.y, p.z + by.z};
  return points;
}

TEST(Apart, FacesWithACommonPointAreNot) {
  Random random(1);
  // The numbers have few digits, so that the common point is one, and triangles contain it.
  for (const double unit : {1.0, 0x1p-1000, 0x1p-1060, 0x1p900, 0x1p1010})
    for (int i = 0; i < 3000; ++i) {
      const Vec3 l = random.lattice_point(1 << 20);
      const Vec3 common{l.x * unit, l.y * unit, l.z * unit};
      const Points a = triangle(random, common, unit, i % 10),
                   b = triangle(random, common, unit, 0);
      EXPECT_FALSE(apart(Hull(a), Hull(b)));
      EXPECT_FALSE(apart(OrientedBox(a), OrientedBox(b)));
      Bounds bounds;
      for (const Vec3& p : a) bounds.add(p);
      EXPECT_FALSE(apart(FaceSlab(b), bounds.box()));
      if (std::isfinite(bounds.box().high[0])) {
        EXPECT_FALSE(apart(OrientedBox(bounds.box()), OrientedBox(b)));
      }
    }
}

TEST(Apart, ABoxThatTouchesAPolygonIsNot) {
  Random random(3);
  for (const double unit : {1.0, 0x1p-120, 0x1p100, 0x1p-1060, 0x1p900})
    for (int i = 0; i < 3000; ++i) {
      const Vec3 l = random.lattice_point(1 << 20);
      const Vec3 common{l.x * unit, l.y * unit, l.z * unit};
      const Points polygon = triangle(random, common, unit, i % 10);
      // The point is a corner of the box.
      Bounds bounds;
      bounds.add(common);
      const auto step = [&] { return (i % 2 == 0 ? 1 : 0x1p-30) * random.upto(1000) * unit; };
      bounds.add({common.x + step(), common.y + step(), common.z + step()});
      EXPECT_FALSE(apart(FaceSlab(polygon), bounds.box()));
    }
}

TEST(Apart, ABoxThatAPolygonPassesIs) {
  Bounds bounds;
  bounds.add({0, 0, 0});
  bounds.add({1, 1, 1});
  // All of it around the box, slanted.
  const Points triangle{{-3, 0, 0.01}, {3, -3, 0.01}, {3, 6, 3.01}};
  EXPECT_FALSE(apart(FaceSlab(triangle), bounds.box()));
  EXPECT_TRUE(apart(FaceSlab(moved(triangle, {0, 0, 2})), bounds.box()));
  EXPECT_TRUE(apart(FaceSlab(moved(triangle, {0, 0, -3})), bounds.box()));
  Points hexagon;
  for (int i = 0; i < 6; ++i)
    hexagon.push_back({3 * std::cos(i * 1.0472), 3 * std::sin(i * 1.0472), 1.000001});
  EXPECT_TRUE(apart(FaceSlab(hexagon), bounds.box()));
  EXPECT_FALSE(apart(FaceSlab(moved(hexagon, {0, 0, -0.000001})), bounds.box()));
}

TEST(Apart, FacesWithACommonCornerAreNotWhenItIsRounded) {
  std::mt19937 engine(2);
  std::uniform_real_distribution<double> anywhere(-1, 1);
  const auto point = [&] { return Vec3{anywhere(engine), anywhere(engine), anywhere(engine)}; };
  for (int i = 0; i < 5000; ++i) {
    // The true corner lies between two doubles; each face may have got another one.
    const Vec3 corner = point();
    const Vec3 next{std::nextafter(corner.x, 2), std::nextafter(corner.y, -2), corner.z};
    EXPECT_FALSE(
        apart(Hull(Points{corner, point(), point()}), Hull(Points{point(), next, point()})));
    EXPECT_FALSE(apart(OrientedBox(Points{corner, point(), point()}),
                       OrientedBox(Points{point(), next, point()})));
  }
}

TEST(Apart, FacesThatTouchInOnePlaneAreNot) {
  const Points square{{0, 0, 0}, {3, 4, 0}, {-1, 7, 0}, {-4, 3, 0}};
  const Points beside = moved(square, {3, 4, 0});
  EXPECT_FALSE(apart(Hull(square), Hull(beside)));
  EXPECT_TRUE(apart(Hull(square), Hull(moved(square, {3.001, 4.001, 0}))));
}

TEST(Apart, PolygonsOfManyCornersAreTakenAsBoxes) {
  Points disc;
  for (int i = 0; i < 100; ++i) disc.push_back({std::cos(i / 16.0), std::sin(i / 16.0), 0});
  const Points needle{{0.999, -5, -5}, {0.999, 5, 5}, {1, 5, 5}};
  EXPECT_FALSE(apart(Hull(disc), Hull(needle)));
  EXPECT_TRUE(apart(Hull(disc), Hull(moved(needle, {0, 0, 9}))));
  EXPECT_TRUE(apart(Hull(disc), Hull(moved(disc, {0, 0, 0x1p-30}))));
}

TEST(Apart, SkewNeedlesAre) {
  const Points one{{-1, -1, -1}, {1, 1, 1}, {1, 1, 1.001}};
  const Points other{{-1, 1, -0.9}, {1, -1, 1.1}, {1, -1, 1.101}};
  EXPECT_TRUE(apart(Hull(one), Hull(other)));
  EXPECT_TRUE(apart(OrientedBox(one), OrientedBox(other)));
}

TEST(Apart, NumbersNearTheEndOfDoublesAreNeverTakenForApart) {
  constexpr double huge = std::numeric_limits<double>::max();
  const Points a{{-huge, 0, 0}, {huge, huge, 0}, {huge, -huge, huge}};
  const Points b{{huge, huge, huge}, {-huge, huge, huge}, {0, -huge, -huge}};
  EXPECT_FALSE(apart(Hull(a), Hull(b)));
  EXPECT_FALSE(apart(OrientedBox(a), OrientedBox(b)));
  Bounds bounds;
  for (const Vec3& p : b) bounds.add(p);
  EXPECT_FALSE(apart(FaceSlab(a), bounds.box()));
  Bounds small;
  small.add({0, 0, 0});
  EXPECT_FALSE(apart(FaceSlab(a), small.box()));
}

}  // namespace
}  // namespace sectile
