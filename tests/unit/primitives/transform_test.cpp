#include "sectile/transform.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "geometry/frame.h"
#include "numbers/dyadic.h"
#include "sectile/boolean.h"
#include "sectile/primitives.h"
#include "sectile/validate.h"
#include "storage/solid_data.h"

namespace sectile {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void expect_legal(const Solid& solid) {
  for (const Violation& violation : validate(solid)) ADD_FAILURE() << violation.what;
}

double slow_dot(const double a[4], const double b[4]) {
  Dyadic sum;
  for (int i = 0; i < 4; ++i) sum = sum + Dyadic(a[i]) * Dyadic(b[i]);
  return sum.nearest();
}

TEST(RoundedDot, AgreesWithExactArithmetic) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> mantissa(-1, 1);
  for (const int spread : {0, 20, 60, 400, 1000}) {
    std::uniform_int_distribution<int> exponent(-spread, spread);
    for (int round = 0; round < 4000; ++round) {
      double a[4], b[4];
      for (int i = 0; i < 4; ++i) {
        a[i] = std::scalbn(mantissa(random), exponent(random) / 2);
        b[i] = std::scalbn(mantissa(random), exponent(random) / 2);
      }
      if (round % 4 == 0) a[3] = -a[2], b[3] = std::nextafter(b[2], infinity);
      if (round % 8 == 0) a[1] = -a[0], b[1] = b[0];
      EXPECT_EQ(rounded_dot(a, b), slow_dot(a, b));
    }
  }
}

TEST(RoundedDot, BreaksTiesToEven) {
  const double one[] = {1, 1, 1, 1};
  const double down[] = {1, 0x1p-53, 0, 0}, up[] = {1 + 0x1p-52, 0x1p-53, 0, 0};
  EXPECT_EQ(rounded_dot(down, one), 1);
  EXPECT_EQ(rounded_dot(up, one), 1 + 0x1p-51);
  const double above[] = {1, 0x1p-53, 0x1p-200, 0};
  EXPECT_EQ(rounded_dot(above, one), 1 + 0x1p-52);
}

TEST(RoundedDot, UnderflowAndOverflow) {
  const double tiny[] = {0x1p-600, 0, 0, 0}, small[] = {0x1p-474, 0, 0, 0};
  EXPECT_EQ(rounded_dot(tiny, small), 0x1p-1074);
  const double huge[] = {0x1p1000, -0x1p1000, 0, 3}, scale[] = {0x1p100, 0x1p100, 0, 1};
  EXPECT_EQ(rounded_dot(huge, scale), 3);
  const double large[] = {0x1p1000, 0, 0, 0};
  EXPECT_EQ(rounded_dot(large, scale), infinity);
}

TEST(Transform, RightAnglesAreExact) {
  const Vec3 p{1.1, 2.3, 3.7};
  for (int k = -4; k <= 4; ++k) {
    const double angle = 90.0 * (4 * k + 1);
    EXPECT_EQ(Transform::rotation_degrees({0, 0, 5}, angle)(p), (Vec3{-2.3, 1.1, 3.7}));
    EXPECT_EQ(Transform::rotation_degrees({3, 0, 0}, angle)(p), (Vec3{1.1, -3.7, 2.3}));
    EXPECT_EQ(Transform::rotation_degrees({0, 0.1, 0}, angle)(p), (Vec3{3.7, 2.3, -1.1}));
    EXPECT_EQ(Transform::rotation_degrees({0, 0, -1}, angle)(p), (Vec3{2.3, -1.1, 3.7}));
  }
  EXPECT_EQ(Transform::rotation_degrees({0, 1e-320, 0}, 180)(p), (Vec3{-1.1, 2.3, -3.7}));
}

TEST(Transform, RotationAboutAnAxisKeepsTheAxis) {
  for (int degrees = -180; degrees <= 180; degrees += 7) {
    const Transform t = Transform::rotation_degrees({0, 0, 2}, degrees);
    EXPECT_EQ(t.m[10], 1);
    EXPECT_EQ(t(Vec3{0, 0, 0.3}), (Vec3{0, 0, 0.3}));
    const Transform u = Transform::rotation_degrees({1, 2, -3}, degrees);
    const Vec3 axis = u({1, 2, -3});
    EXPECT_NEAR(axis.x, 1, 1e-14);
    EXPECT_NEAR(axis.y, 2, 1e-14);
    EXPECT_NEAR(axis.z, -3, 1e-14);
  }
}

TEST(Transform, ProductsApplyTheRightOneFirst) {
  const Transform move = Transform::translation({1, 2, 3});
  const Transform grow = Transform::scaling({2, 4, 8});
  const Vec3 p{1, 1, 1};
  EXPECT_EQ((grow * move)(p), (Vec3{4, 12, 32}));
  EXPECT_EQ((move * grow)(p), (Vec3{3, 6, 11}));
}

TEST(Transform, BadArgumentsThrow) {
  const Solid solid = block({0, 0, 0}, {1, 1, 1});
  EXPECT_THROW(Transform::rotation_degrees({0, 0, 0}, 1), std::invalid_argument);
  EXPECT_THROW(Transform::rotation_degrees({0, infinity, 0}, 1), std::invalid_argument);
  EXPECT_THROW(Transform::rotation_degrees({0, 0, 1}, infinity), std::invalid_argument);
  EXPECT_THROW(transformed(solid, Transform::scaling({1, 0, 1})), std::invalid_argument);
  EXPECT_THROW(transformed(Solid(), Transform::scaling({1, 0, 1})), std::invalid_argument);
  EXPECT_THROW(transformed(solid, Transform::translation({infinity, 0, 0})), std::invalid_argument);
  EXPECT_THROW(transformed(solid.to_mesh(), Transform::scaling({1, std::nan(""), 1})),
               std::invalid_argument);
  EXPECT_THROW(
      transformed(block({0, 0, 0}, {4, 1, 1}).to_mesh(), Transform::scaling({0x1p1023, 1, 1})),
      std::invalid_argument);
  // Singular, though the determinant in floating point is not zero or is zero wrongly.
  Transform thin = Transform::scaling({0x1p-500, 0x1p-500, 0x1p-500});
  EXPECT_NO_THROW(transformed(Solid(), thin));
  const Transform flat{{0.1, 0.3, 0, 0, 0.2, 0.6, 0, 0, 0, 0, 1, 0}};
  EXPECT_THROW(transformed(solid, flat), std::invalid_argument);
}

TEST(TransformedMesh, MirroringTurnsFaces) {
  PolygonMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {3, 4}, {0, 1, 2, 0, 1, 3, 2}};
  const PolygonMesh same = transformed(mesh, Transform::scaling({2, 2, 2}));
  EXPECT_EQ(same.indices, mesh.indices);
  EXPECT_EQ(same.positions[3], (Vec3{2, 2, 0}));
  const PolygonMesh mirrored = transformed(mesh, Transform::scaling({1, 1, -1}));
  EXPECT_EQ(mirrored.indices, (std::vector<std::uint32_t>{2, 1, 0, 2, 3, 1, 0}));
  mesh.face_sizes.push_back(3);
  EXPECT_THROW(transformed(mesh, Transform::scaling({1, 1, -1})), std::invalid_argument);
}

std::vector<FaceSource> sorted_sources(const Solid& solid) {
  const auto& found = solid.data()->brep().source;
  std::vector<FaceSource> sources(found.begin(), found.end());
  std::sort(sources.begin(), sources.end());
  return sources;
}

TEST(TransformedSolid, ExactImagesKeepTheStructure) {
  const Profile profile{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {2, 1}, {2, 2}, {1, 2}}}};
  const Solid solid = extrude(profile, 3);
  for (const Transform& t :
       {Transform::translation({1, -2, 0.5}), Transform::scaling({2, 0.5, 4}),
        Transform::scaling({-1, 1, 1}), Transform::rotation_degrees({1, 0, 0}, 90),
        Transform::scaling({1, -1, 1}) * Transform::rotation_degrees({0, 1, 0}, 270)}) {
    const Solid moved = transformed(solid, t);
    expect_legal(moved);
    EXPECT_EQ(moved.volume(), (t.m == Transform::scaling({2, 0.5, 4}).m ? 4 : 1) * solid.volume());
    EXPECT_EQ(moved.counts().loops, solid.counts().loops);
    EXPECT_EQ(moved.counts().genus, 1);
    EXPECT_EQ(moved.origin(), solid.origin());
    EXPECT_EQ(sorted_sources(moved), sorted_sources(solid));
  }
}

TEST(TransformedSolid, MirroringTwiceIsTheSolid) {
  const Solid solid = wedge({0.1, 0.2, 0.3}, {1.7, 2.9, 3.3});
  const Transform mirror = Transform::scaling({-1, 1, 1});
  EXPECT_FALSE(transformed(solid, mirror) == solid);
  EXPECT_TRUE(transformed(transformed(solid, mirror), mirror) == solid);
}

TEST(TransformedSolid, TurnedImagesAreLegalAndKeepSources) {
  const Solid solid = extrude({{{0, 0}, {4, 0}, {4, 3}, {2, 1}, {0, 4}}, {}}, 3);
  const Solid moved = transformed(solid, Transform::rotation_degrees({1, 2, 3}, 25));
  expect_legal(moved);
  EXPECT_NEAR(moved.volume(), solid.volume(), 1e-12);
  EXPECT_NEAR(moved.area(), solid.area(), 1e-12);
  EXPECT_EQ(moved.counts().vertices, solid.counts().vertices);
  EXPECT_EQ(moved.origin(), solid.origin());
  for (const FaceSource& source : moved.data()->brep().source) {
    EXPECT_EQ(source.solid, solid.origin());
    EXPECT_LT(source.face, solid.counts().faces);
  }
  const Solid mirrored = transformed(
      moved, Transform::scaling({-1, 1, 1}) * Transform::rotation_degrees({3, 1, 1}, 1));
  expect_legal(mirrored);
  EXPECT_NEAR(mirrored.volume(), solid.volume(), 1e-12);
}

// A result with implicit points: two turned blocks, whose edges meet in no doubles.
class TransformedResult : public testing::Test {
 protected:
  Solid result() const {
    const Solid a = block({0, 0, 0}, {1, 1, 1});
    const Solid b = transformed(block({-1, -1, -1}, {0.5, 0.5, 0.5}),
                                Transform::rotation_degrees({1, 1, 2}, 20));
    return boolean(a, b, Operation::subtract);
  }
};

TEST_F(TransformedResult, ExactMovesAreReversible) {
  const Solid solid = result();
  ASSERT_FALSE(solid.data()->geometry().constructions.empty());
  for (const Transform& t : {Transform::scaling({-1, 1, 1}), Transform::scaling({2, 2, 2}),
                             Transform::rotation_degrees({0, 0, 1}, 90)}) {
    const Solid moved = transformed(solid, t);
    expect_legal(moved);
    EXPECT_NEAR(moved.volume(), solid.volume() * (t.m[0] == 2 ? 8 : 1), 1e-12);
    EXPECT_EQ(moved.data()->geometry().constructions.size(),
              solid.data()->geometry().constructions.size());
    const Transform back = t.m[0] == 2    ? Transform::scaling({0.5, 0.5, 0.5})
                           : t.m[0] == -1 ? t
                                          : Transform::rotation_degrees({0, 0, 1}, -90);
    EXPECT_TRUE(transformed(moved, back) == solid);
  }
}

TEST_F(TransformedResult, TurnedMovesAreLegal) {
  const Solid solid = result();
  const Solid moved = transformed(solid, Transform::rotation_degrees({1, 0, 1}, 33));
  expect_legal(moved);
  EXPECT_NEAR(moved.volume(), solid.volume(), 1e-12);
  EXPECT_EQ(moved.counts().faces, solid.counts().faces);
  EXPECT_EQ(moved.data()->geometry().constructions.size(),
            solid.data()->geometry().constructions.size());
}

const Transform exact_transforms[] = {
    Transform::translation({1, -2, 0.5}), Transform::scaling({2, 0.5, -4}),
    Transform::rotation_degrees({0, 1, 0}, 90),
    Transform::scaling({1, -1, 1}) * Transform::rotation_degrees({1, 0, 0}, 270)};

// Faces of one plane beside each other, whose edges need a plane of their own.
TEST(TransformedSolid, ExactMovesCommuteWithBooleans) {
  const Solid a = extrude({{{0, 0}, {2, 0}, {4, 0}, {4, 4}, {1, 5}, {0, 4}}, {}}, 3);
  const Solid b = block({1, -1, 1}, {3, 2, 4});
  for (const Transform& t : exact_transforms)
    for (const Operation operation :
         {Operation::unite, Operation::intersect, Operation::subtract}) {
      const Solid before = boolean(transformed(a, t), transformed(b, t), operation);
      const Solid after = transformed(boolean(a, b, operation), t);
      expect_legal(after);
      EXPECT_TRUE(before == after);
      EXPECT_EQ(before.counts().faces, after.counts().faces);
      const Solid c = transformed(block({-1, 1, 0.5}, {5, 1.5, 1.5}), t);
      EXPECT_TRUE(boolean(before, c, Operation::subtract) ==
                  boolean(after, c, Operation::subtract));
    }
}

TEST(TransformedSolid, PlanesGivenByCoefficientsMoveExactly) {
  const Solid part = split(block({0, 0, 0}, {1, 1, 1}), {1, 2, 3, -3.5}).first;
  ASSERT_FALSE(part.data()->geometry().coefficients.empty());
  for (const Transform& t : exact_transforms) {
    const Solid moved = transformed(part, t);
    expect_legal(moved);
    EXPECT_FALSE(moved.data()->geometry().coefficients.empty());
    EXPECT_NEAR(moved.volume(), part.volume() * (t.m[0] == 2 ? 4 : 1), 1e-12);
    const Solid whole = transformed(block({0, 0, 0}, {1, 1, 1}), t);
    EXPECT_TRUE(boolean(moved, whole, Operation::subtract).is_empty());
    EXPECT_TRUE(boolean(moved, whole, Operation::intersect) == moved);
  }
}

}  // namespace
}  // namespace sectile
