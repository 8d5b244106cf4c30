// Sections of solids by planes, as loops.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sectile/sectile.h"
#include "storage/solid_data.h"
#include "unit/split/vectors.h"

namespace sectile {
namespace {

using test::cross, test::dot;

double value(const HalfSpace& h, const Vec3& p) {
  return h.a * p.x + h.b * p.y + h.c * p.z + h.d;
}

// Twice the area to the left of a way, as seen against the normal, if it is part of a loop.
double swept(const Vec3& from, const Vec3& to, const HalfSpace& h) {
  const Vec3 n{h.a, h.b, h.c};
  return dot(cross(from, to), n) / std::sqrt(dot(n, n));
}

struct Measure {
  double area = 0, length = 0;

  void add(const Vec3& from, const Vec3& to, const HalfSpace& h) {
    area += swept(from, to, h) / 2;
    length += std::hypot(to.x - from.x, to.y - from.y, to.z - from.z);
  }
};

Measure measure(const std::vector<Vec3>& loop, const HalfSpace& h) {
  Measure of;
  for (std::size_t i = 0; i < loop.size(); ++i) of.add(loop[i], loop[(i + 1) % loop.size()], h);
  return of;
}
Measure measure(const Section& section, const HalfSpace& h) {
  Measure all;
  for (const auto& loop : section.loops) {
    const Measure one = measure(loop, h);
    all.area += one.area;
    all.length += one.length;
  }
  return all;
}

// Of the segments in which the triangles of a mesh, none with a corner on it, meet the plane. Seen
// from outside, what is above lies to the left of the way that has the material on its left.
Measure measure_of_mesh(const PolygonMesh& mesh, const HalfSpace& h) {
  Measure all;
  for (std::size_t t = 0; t < mesh.face_sizes.size(); ++t) {
    Vec3 from, to;
    bool crosses = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 &p = mesh.positions[mesh.indices[3 * t + k]],
                 &q = mesh.positions[mesh.indices[3 * t + (k + 1) % 3]];
      const double a = value(h, p), b = value(h, q);
      if ((a > 0) == (b > 0)) continue;
      const double s = a / (a - b);
      const Vec3 at{p.x + s * (q.x - p.x), p.y + s * (q.y - p.y), p.z + s * (q.z - p.z)};
      (a > 0 ? from : to) = at;
      crosses = true;
    }
    if (crosses) all.add(from, to, h);
  }
  return all;
}

void expect_as_of_triangles(const Solid& solid, const HalfSpace& h) {
  const Measure of = measure(section(solid, h), h), expected = measure_of_mesh(solid.to_mesh(), h);
  EXPECT_NEAR(of.area, expected.area, 1e-9);
  EXPECT_NEAR(of.length, expected.length, 1e-9);
}

Solid drilled_plate(int columns) {
  std::vector<Solid> holes;
  for (int i = 0; i < columns * columns; ++i)
    holes.push_back(transformed(
        cylinder(0.25, 4, 8), Transform::translation({i % columns + 0.5, i / columns + 0.5, -1})));
  return subtract(block({0, 0, 0}, {1.0 * columns, 1.0 * columns, 2}), holes);
}

TEST(Section, OfABlockIsARectangleThatRunsToTheLeft) {
  const HalfSpace up{0, 0, 1, -1}, down{0, 0, -1, 1};
  for (const HalfSpace& h : {up, down}) {
    const Section s = section(block({0, 0, 0}, {2, 3, 4}), h);
    ASSERT_EQ(s.loops.size(), 1u);
    EXPECT_EQ(s.loops[0].size(), 4u);
    EXPECT_EQ(measure(s, h).area, 6);
    for (const Vec3& p : s.loops[0]) EXPECT_EQ(p.z, 1);
  }
}

TEST(Section, OfATubeIsARing) {
  const Solid tube =
      boolean(block({0, 0, 0}, {4, 4, 4}), block({1, 1, -1}, {3, 3, 5}), Operation::subtract);
  const HalfSpace h{0, 0, 1, -2};
  const Section s = section(tube, h);
  ASSERT_EQ(s.loops.size(), 2u);
  EXPECT_EQ(measure(s, h).area, 12);
  EXPECT_EQ(std::min(measure(s.loops[0], h).area, measure(s.loops[1], h).area), -4);
}

// What is on both sides of the plane is cut, a step in it is not.
TEST(Section, InThePlaneOfAStepIsWhatGoesOnAbove) {
  const Solid stairs =
      boolean(block({0, 0, 0}, {2, 1, 1}), block({1, 0, 1}, {2, 1, 2}), Operation::unite);
  const HalfSpace h{0, 0, 1, -1};
  EXPECT_EQ(measure(section(stairs, h), h).area, 1);
}

TEST(Section, OfWhatThePlaneTouchesIsNothing) {
  const Solid cube = block({0, 0, 0}, {1, 1, 1});
  for (const HalfSpace& h : {HalfSpace{0, 0, 1, 0}, HalfSpace{0, 0, 1, -1}, HalfSpace{1, 1, 0, 0},
                             HalfSpace{1, 1, 1, -3}, HalfSpace{1, 0, 0, -5}})
    EXPECT_TRUE(section(cube, h).loops.empty());
  EXPECT_TRUE(section(Solid(), {0, 0, 1, 0}).loops.empty());
}

TEST(Section, IsWhereThePlaneMeetsTheTriangles) {
  const HalfSpace planes[] = {
      {0.1, 0.2, 1, 0.1}, {1, 0.3, -0.2, 0.05}, {-0.3, 1, 0.4, -0.31}, {1, 1, 1.1, 0.77}};
  const Solid ball = Solid::from_mesh(sphere(1, 96, 48).to_mesh()),
              ring = transformed(torus(1, 0.4, 64, 32), Transform::rotation_degrees({3, 1, 2}, 33)),
              result = boolean(ball, ring, Operation::subtract);
  ASSERT_GT(ball.data()->slots().size(), 4u);
  for (const Solid& solid :
       {ball, ring, result, transformed(result, Transform::scaling({1, -2, 1}))})
    for (const HalfSpace& h : planes) expect_as_of_triangles(solid, h);
}

// Its large faces are alone in their blocks, and most of their loops are not loaded.
TEST(Section, OfAPlateWithManyHolesHasALoopForEach) {
  const int columns = 10;
  const Solid plate = drilled_plate(columns);
  const HalfSpace along{0, 0, 1, -1}, across{1, 0, 0, -4.5}, aslant{1, 0.25, 0.125, -5.07};
  EXPECT_EQ(section(plate, along).loops.size(), 1u + columns * columns);
  EXPECT_EQ(section(plate, across).loops.size(), 1u + columns);
  const Solid upper = split(plate, along).first, part = split(upper, aslant).second;
  for (const Solid& solid : {plate, upper, part}) {
    expect_as_of_triangles(solid, {0, 0, 1, -1.53});
    expect_as_of_triangles(solid, {1, 0.01, 0.02, -4.517});
    expect_as_of_triangles(solid, {0.2, 1, 0.1, -6.013});
  }
}

}  // namespace
}  // namespace sectile
