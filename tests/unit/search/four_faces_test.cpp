// Faces beside each other's planes and beside boxes: what is told apart is apart, whatever its
// place, size and shape, and what lies on one side of a plane is told.
#include "search/four_faces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace sectile {
namespace {

using Points = std::vector<Vec3>;

constexpr unsigned all_four = 0xF;

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  int upto(int most) { return std::uniform_int_distribution<int>(-most, most)(engine_); }
  Vec3 lattice_point(int most, double unit) {
    return {upto(most) * unit, upto(most) * unit, upto(most) * unit};
  }
  double anywhere() { return std::uniform_real_distribution<double>(-1, 1)(engine_); }
  Vec3 point() { return {anywhere(), anywhere(), anywhere()}; }

 private:
  std::mt19937 engine_;
};

Vec3 operator+(const Vec3& p, const Vec3& q) {
  return {p.x + q.x, p.y + q.y, p.z + q.z};
}
Vec3 operator-(const Vec3& p, const Vec3& q) {
  return {p.x - q.x, p.y - q.y, p.z - q.z};
}

// Its middle is a point, exactly, as all coordinates are multiples of `unit` with few digits.
Points polygon_around(Random& random, const Vec3& middle, double unit, int size, bool of_four) {
  const Vec3 u = random.lattice_point(size, unit), v = random.lattice_point(size, unit);
  if (of_four) return {middle + u, middle + v, middle - u, middle - v};
  // The point is the middle of a median.
  return {middle + u + v, middle + u - v, middle - u};
}

FourFaces all(const Points& face) {
  FourFaces faces;
  for (unsigned i = 0; i < 4; ++i) faces.set(i, face);
  return faces;
}

bool are_apart(const Points& a, const Points& b) {
  const FourFaces of_a = all(a), of_b = all(b);
  const unsigned one_way = of_a.apart_from(of_b, 2), other_way = of_b.apart_from(of_a, 1);
  EXPECT_TRUE(one_way == 0 || one_way == all_four);
  EXPECT_EQ(one_way, other_way);
  return one_way != 0;
}

bool are_apart(const Points& face, const Box& box) {
  return all(face).apart_from(box) != 0;
}

constexpr double units[] = {1,        0x1p-40,   0x1p-100, 0x1p-135, 0x1p-149,
                            0x1p-163, 0x1p-1060, 0x1p100,  0x1p120,  0x1p1000};

TEST(FourFaces, FacesWithACommonPointAreNeverApart) {
  Random random(1);
  for (const double unit : units)
    for (int i = 0; i < 2000; ++i) {
      const Vec3 common = random.lattice_point(i % 2 == 0 ? 1 << 20 : 1000, unit);
      const int size = 1 << (i % 21);
      const Points a = polygon_around(random, common, unit, size, i % 3 == 0),
                   b = polygon_around(random, common, unit, 1000, i % 5 == 0);
      EXPECT_FALSE(are_apart(a, b)) << unit << ' ' << i;
    }
}

TEST(FourFaces, AFaceThatABoxTouchesIsNeverApartFromIt) {
  Random random(2);
  for (const double unit : units)
    for (int i = 0; i < 2000; ++i) {
      const Vec3 common = random.lattice_point(1 << 20, unit);
      const Points face = polygon_around(random, common, unit, 1 << (i % 21), i % 3 == 0);
      Bounds bounds;  // with the point as a corner
      bounds.add(common);
      bounds.add(common + random.lattice_point(i % 2 == 0 ? 1000 : 1, unit));
      EXPECT_FALSE(are_apart(face, bounds.box())) << unit << ' ' << i;
    }
}

// Neither corners nor planes are known exactly in floats.
TEST(FourFaces, FacesWithACommonCornerAreNeverApart) {
  Random random(3);
  for (int i = 0; i < 20000; ++i) {
    const Vec3 far = i % 2 == 0 ? Vec3{} : Vec3{1e6, -1e3, 1e5};
    const Vec3 corner = far + random.point();
    // The true corner lies between two doubles; each face may have got another one.
    const Vec3 next{std::nextafter(corner.x, 1e9), std::nextafter(corner.y, -1e9), corner.z};
    const double size = std::ldexp(1.0, -(i % 30));
    const auto beside = [&](const Vec3& p) {
      const Vec3 by = random.point();
      return Vec3{p.x + size * by.x, p.y + size * by.y, p.z + size * by.z};
    };
    EXPECT_FALSE(
        are_apart({corner, beside(corner), beside(corner)}, {random.point(), next, beside(next)}));
  }
}

TEST(FourFaces, WhatLiesOnOneSideOfAPlaneIsApart) {
  const Points slanted{{0, 0, 0}, {4, 0, 3}, {0, 4, 3}};
  const Points through{{1, 1, -5}, {1, 2, 9}, {2, 1, 9}};
  EXPECT_FALSE(are_apart(slanted, through));
  const Points above{{1, 1, 1.6}, {1, 2, 9}, {2, 1, 9}}, below{{1, 1, 1.4}, {1, 2, -9}, {2, 1, -9}};
  EXPECT_TRUE(are_apart(slanted, above));
  EXPECT_TRUE(are_apart(slanted, below));
  // Also where only one of the planes tells.
  EXPECT_TRUE(are_apart({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}, {{5, 0, 0}, {5, 1, 0}, {5, 0, 2}}));
}

TEST(FourFaces, ABoxOnOneSideOfAPlaneIsApart) {
  const Points slanted{{-9, 0, -9}, {9, -9, 9}, {9, 9, 9}};  // z = x
  const auto box_at = [](const Vec3& p) { return box_around(p, p + Vec3{1, 1, 1}); };
  EXPECT_TRUE(are_apart(slanted, box_at({0, 0, 1.01})));
  EXPECT_FALSE(are_apart(slanted, box_at({0, 0, 0.99})));
  EXPECT_TRUE(are_apart(slanted, box_at({0, 0, -1.01})));
  EXPECT_FALSE(are_apart(slanted, box_at({0, 0, -0.99})));
  EXPECT_FALSE(are_apart(slanted, Box::everything()));
}

TEST(FourFaces, EachHasItsPlace) {
  FourFaces faces;
  const auto at = [](double z) { return Points{{0, 0, z}, {1, 0, z}, {0, 1, z}}; };
  for (unsigned i = 0; i < 4; ++i) faces.set(i, at(i));
  const FourFaces one = all({{0, 0, 0.5}, {1, 1, 0.5}, {1, 1, 2.5}});
  EXPECT_EQ(faces.apart_from(box_around({0, 0, 0.5}, {1, 1, 2.5})), 0b1001u);
  EXPECT_EQ(one.apart_from(faces, 0), 0b1001u);
  for (unsigned i = 0; i < 4; ++i)
    EXPECT_EQ(faces.apart_from(one, i), i == 0 || i == 3 ? all_four : 0u);
}

TEST(FourFaces, APolygonOfManyCornersHasAPlaneOnly) {
  Points disc;
  for (int i = 0; i < 12; ++i) disc.push_back({std::cos(i / 2.0), std::sin(i / 2.0), 0});
  EXPECT_TRUE(are_apart(disc, {{0, 0, 1}, {1, 0, 1}, {0, 1, 2}}));
  EXPECT_FALSE(are_apart(disc, {{0, 0, -1}, {0.5, 0, 1}, {0, 0.5, 2}}));
  // All corners are on one side of the other plane, which is not looked at.
  EXPECT_FALSE(are_apart(disc, {{5, 0, -1}, {5, 1, 1}, {5, -1, 1}}));
  EXPECT_TRUE(are_apart(disc, box_around({-9, -9, 0.1}, {9, 9, 0.2})));
}

TEST(FourFaces, WhatFloatsCannotSayIsNotApart) {
  constexpr double huge = std::numeric_limits<double>::max();
  const Points a{{-huge, 0, 0}, {huge, huge, 0}, {huge, -huge, huge}};
  const Points b{{huge, huge, huge}, {-huge, huge, huge}, {0, -huge, -huge}};
  const Points flat{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
  const Points small{{0, 0, 1e-300}, {1e-300, 0, 1e-300}, {0, 1e-300, 1e-300}};
  for (const Points& p : {a, b, flat, small})
    for (const Points& q : {a, b, flat, small}) EXPECT_FALSE(are_apart(p, q));
  for (const Points& p : {a, b, flat}) EXPECT_FALSE(are_apart(p, box_around({0, 0, 0}, {1, 1, 1})));
  EXPECT_EQ(FourFaces().apart_from(Box()), 0u);
}

}  // namespace
}  // namespace sectile
