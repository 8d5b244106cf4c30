// Pairs that nearly coincide: turned by tiny angles, shifted by single ulps.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sectile/sectile.h"

namespace sectile::test {
namespace {

// vol(A ∪ B) + vol(A ∩ B) = vol A + vol B, and A \ B with A ∩ B makes A.
void expect_consistent(const Solid& a, const Solid& b, const std::string& what) {
  const Solid both = boolean(a, b, Operation::intersect), any = boolean(a, b, Operation::unite),
              rest = boolean(a, b, Operation::subtract);
  const double total = a.volume() + b.volume();
  EXPECT_NEAR(any.volume() + both.volume(), total, 1e-12 * total) << what;
  EXPECT_NEAR(rest.volume() + both.volume(), a.volume(), 1e-12 * total) << what;
  for (const Solid* s : {&both, &any, &rest}) EXPECT_TRUE(validate(*s, false).empty()) << what;
}

Solid moved(const PolygonMesh& mesh, double angle, const Vec3& axis) {
  // Without degrees, so that the angle is as small as it is meant.
  PolygonMesh result = mesh;
  const double length = std::hypot(axis.x, axis.y, axis.z);
  const Vec3 u{axis.x / length, axis.y / length, axis.z / length};
  for (Vec3& p : result.positions) {
    const Vec3 w{u.y * p.z - u.z * p.y, u.z * p.x - u.x * p.z, u.x * p.y - u.y * p.x};
    p = {p.x + angle * w.x, p.y + angle * w.y, p.z + angle * w.z};
  }
  return Solid::from_mesh(result);
}

std::vector<Solid> shapes() {
  const Solid cube = block({-1, -1, -1}, {1, 1, 1});
  return {cube, pyramid(1.3, 2.1, 3), sphere(1, 12, 6),
          boolean(cube, block({0, 0, -1}, {1, 1, 1}), Operation::subtract)};
}

TEST(NearDegenerate, SolidsTurnedByTinyAngles) {
  for (const Solid& shape : shapes()) {
    const PolygonMesh mesh = shape.to_mesh();
    const Solid a = Solid::from_mesh(mesh);
    for (double angle = 1e-16; angle < 2e-3; angle *= 10)
      for (const Vec3& axis : {Vec3{0, 0, 1}, Vec3{1, 0, 0}, Vec3{1, 2, 3}})
        expect_consistent(a, moved(mesh, angle, axis),
                          "angle " + std::to_string(std::log10(angle)));
  }
}

TEST(NearDegenerate, SolidsShiftedBySingleUlps) {
  for (const Solid& shape : shapes()) {
    const PolygonMesh mesh = shape.to_mesh();
    const Solid a = Solid::from_mesh(mesh);
    for (int ulps = 1; ulps <= 4; ++ulps)
      for (int axis = 0; axis < 4; ++axis) {
        PolygonMesh shifted = mesh;
        const auto shift = [&](double& c) {
          for (int i = 0; i < ulps; ++i)
            c = std::nextafter(c, std::numeric_limits<double>::infinity());
        };
        for (Vec3& p : shifted.positions) {
          if (axis == 0 || axis == 3) shift(p.x);
          if (axis == 1 || axis == 3) shift(p.y);
          if (axis == 2 || axis == 3) shift(p.z);
        }
        expect_consistent(a, Solid::from_mesh(shifted), "ulps " + std::to_string(ulps));
      }
  }
}

}  // namespace
}  // namespace sectile::test
