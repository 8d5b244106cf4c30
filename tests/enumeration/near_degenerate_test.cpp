// Pairs that nearly coincide: turned by tiny angles, shifted by single ulps. What they do not share
// is as thin as that; the volumes are those that rational numbers give, to the last places also of
// what is thin.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cases.h"
#include "sectile/sectile.h"
#include "tetrahedra.h"

namespace sectile::test {
namespace {

// Volumes are right to two units in the last place.
void expect_volume(const Solid& solid, const ExactFraction& exact, const std::string& what) {
  EXPECT_TRUE(validate(solid).empty()) << what;
  EXPECT_EQ(solid.is_empty(), exact == 0) << what;
  const double expected = exact.convert_to<double>();
  EXPECT_NEAR(solid.volume(), expected, 4 * std::numeric_limits<double>::epsilon() * expected)
      << what;
}

void expect_exact_volumes(const Tetrahedra& a, const Tetrahedra& b, const std::string& what) {
  const Solid first = Solid::from_mesh(a.boundary()), second = Solid::from_mesh(b.boundary());
  const ExactFraction volume_a = exact_volume(a), volume_b = exact_volume(b),
                      common = exact_common_volume(a, b);
  ASSERT_GT(common, 0) << what;
  ASSERT_LT(common, volume_a) << what;
  expect_volume(boolean(first, second, Operation::intersect), common, what + " intersect");
  expect_volume(boolean(first, second, Operation::unite), volume_a + volume_b - common,
                what + " unite");
  expect_volume(boolean(first, second, Operation::subtract), volume_a - common, what + " subtract");
  expect_volume(boolean(second, first, Operation::subtract), volume_b - common,
                what + " subtract from the other");
}

// Without degrees, so that the angle is as small as it is meant.
Tetrahedra turned(Tetrahedra solid, double angle, const Vec3& axis) {
  const double length = std::hypot(axis.x, axis.y, axis.z);
  const Vec3 u{axis.x / length, axis.y / length, axis.z / length};
  for (Vec3& p : solid.corners) {
    const Vec3 w{u.y * p.z - u.z * p.y, u.z * p.x - u.x * p.z, u.x * p.y - u.y * p.x};
    p = {p.x + angle * w.x, p.y + angle * w.y, p.z + angle * w.z};
  }
  return solid;
}

// Unit cells at integer places, of six tetrahedra each, which all have the same diagonal.
Tetrahedra cells_at(const std::vector<std::array<int, 3>>& places) {
  Tetrahedra solid;
  std::map<std::array<int, 3>, std::uint32_t> number;
  const auto corner = [&](const std::array<int, 3>& p) {
    const auto [at, is_new] = number.emplace(p, solid.corners.size());
    if (is_new) solid.corners.push_back({p[0] - 0.9, p[1] - 0.8, p[2] - 0.7});
    return at->second;
  };
  for (const auto& place : places) {
    std::array<std::size_t, 3> order{0, 1, 2};
    bool even = true;
    for (int step = 0; step < 6; ++step) {
      std::array<std::uint32_t, 4> cell{corner(place)};
      std::array<int, 3> p = place;
      for (std::size_t k = 0; k < 3; ++k) {
        ++p[order[k]];
        cell[k + 1] = corner(p);
      }
      if (!even) std::swap(cell[2], cell[3]);
      solid.cells.push_back(cell);
      std::swap(order[step % 2 == 0 ? 1 : 0], order[step % 2 == 0 ? 2 : 1]);
      even = !even;
    }
  }
  return solid;
}

// Triangles of a convex body, each with the origin.
Tetrahedra ball() {
  const PolygonMesh mesh = sphere(1, 4, 2).to_mesh();
  Tetrahedra solid;
  solid.corners = mesh.positions;
  const auto centre = static_cast<std::uint32_t>(solid.corners.size());
  solid.corners.push_back({0, 0, 0});
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
    solid.cells.push_back({centre, mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]});
  return solid;
}

std::vector<Tetrahedra> shapes() {
  Tetrahedra one{{{-1, -1.1, -0.5}, {1.2, -0.9, -0.6}, {0.1, 1.3, -0.7}, {0.2, 0.1, 1.4}},
                 {{0, 1, 2, 3}}};
  return {one, cells_at({{0, 0, 0}}), cells_at({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}}), ball()};
}

TEST(NearDegenerate, TheJudgeKnowsWhatCubesShare) {
  const Tetrahedra cube = cells_at({{0, 0, 0}});
  Tetrahedra other = cube;
  for (Vec3& p : other.corners) p.x += 0.25;
  EXPECT_EQ(exact_volume(cube).convert_to<double>(), 1);
  EXPECT_NEAR(exact_common_volume(cube, other).convert_to<double>(), 0.75, 1e-15);
  EXPECT_EQ(exact_common_volume(cube, cube), exact_volume(cube));
  EXPECT_EQ(cube.boundary().face_sizes.size(), 12u);
}

TEST(NearDegenerate, SolidsTurnedByTinyAngles) {
  for (const Tetrahedra& shape : shapes())
    for (const double angle : {1e-15, 1e-9, 1e-4})
      for (const Vec3& axis : {Vec3{0, 0, 1}, Vec3{1, 2, 3}})
        expect_exact_volumes(shape, turned(shape, angle, axis),
                             "angle 1e" + std::to_string(std::lround(std::log10(angle))));
}

TEST(NearDegenerate, SolidsShiftedBySingleUlps) {
  for (const Tetrahedra& shape : shapes())
    for (const int ulps : {1, 4})
      for (int axis = 0; axis < cases(4); ++axis) {
        Tetrahedra shifted = shape;
        const auto shift = [&](double& c) {
          for (int i = 0; i < ulps; ++i)
            c = std::nextafter(c, std::numeric_limits<double>::infinity());
        };
        for (Vec3& p : shifted.corners) {
          if (axis == 0 || axis == 3) shift(p.x);
          if (axis == 1 || axis == 3) shift(p.y);
          if (axis == 2 || axis == 3) shift(p.z);
        }
        expect_exact_volumes(shape, shifted, "ulps " + std::to_string(ulps));
      }
}

}  // namespace
}  // namespace sectile::test
