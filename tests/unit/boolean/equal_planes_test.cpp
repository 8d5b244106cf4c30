// What operands have in common is one plane for both, so that no test between them computes
// anything.
#include "boolean/loading/equal_planes.h"

#include <gtest/gtest.h>

#include <set>

#include "geometry/same_definition.h"
#include "sectile/transform.h"
#include "unit/boolean/phases.h"

namespace sectile {
namespace {

using test::Phases;

std::set<PlaneId> planes(const Patch& patch) {
  return {patch.brep.plane.begin(), patch.brep.plane.end()};
}

std::size_t common_planes(const Workspace& w) {
  std::size_t common = 0;
  const std::set<PlaneId> of_a = planes(w.patch[Operand::a]);
  for (const PlaneId s : planes(w.patch[Operand::b])) common += of_a.count(s);
  return common;
}

// Its planes have no coefficients that are doubles.
Solid slanted_tool(double shift) {
  const PolygonMesh cube = block({-0.7, -0.7, -0.7}, {0.7, 0.7, 0.7}).to_mesh();
  return Solid::from_mesh(transformed(cube, Transform::translation({shift, 0.1, 0.3}) *
                                                Transform::rotation_degrees({1, 2, 3}, 40)));
}

TEST(EqualPlanes, AResultAndTheToolThatItWasMadeWithHaveThePlanesOfTheToolInCommon) {
  const Solid tool = slanted_tool(0.9);
  const Solid result = boolean(block({-1, -1, -1}, {1, 1, 1}), tool, Operation::unite);
  const Phases phases(result, tool, Operation::intersect);
  EXPECT_EQ(common_planes(phases.w), planes(phases.w.patch[Operand::b]).size());
  for (const PlaneId p : planes(phases.w.patch[Operand::a]))
    for (const PlaneId q : planes(phases.w.patch[Operand::b]))
      if (p != q) {
        EXPECT_FALSE(have_same_points(phases.w.geometry, phases.w.geometry.definition(p),
                                      phases.w.geometry.definition(q)));
      }
}

TEST(EqualPlanes, SoHavePointsThatWereConstructedWithThem) {
  const Solid tool = slanted_tool(0.9);
  const Solid result = boolean(block({-1, -1, -1}, {1, 1, 1}), tool, Operation::unite);
  const Phases phases(result, tool, Operation::intersect);
  const Geometry& geometry = phases.w.geometry;
  const std::set<PlaneId> of_tool = planes(phases.w.patch[Operand::b]);
  std::size_t constructed = 0;
  for (const PointId p : phases.w.patch[Operand::a].brep.point) {
    if (!geometry.is_constructed(p)) continue;
    ++constructed;
    const Construction& how = geometry.construction(p);
    EXPECT_GT(of_tool.count(how.a) + of_tool.count(how.b) + of_tool.count(how.c), 0u);
  }
  EXPECT_GT(constructed, 0u);
}

TEST(EqualPlanes, NearlyEqualOnesStayApart) {
  const Solid tool = slanted_tool(0.9), beside = slanted_tool(0.9 + 0x1p-50);
  EXPECT_EQ(common_planes(Phases(tool, beside, Operation::unite).w), 0u);
}

TEST(EqualPlanes, OppositeSidesOfOnePlaneAreTwoPlanes) {
  const Solid tool = slanted_tool(0.9);
  const Solid rest = boolean(block({-3, -3, -3}, {3, 3, 3}), tool, Operation::subtract);
  const Phases phases(rest, tool, Operation::unite);
  EXPECT_EQ(common_planes(phases.w), 0u);
  EXPECT_EQ(boolean(rest, tool, Operation::unite), block({-3, -3, -3}, {3, 3, 3}));
}

TEST(EqualPlanes, ImagesUnderOneMapHaveThemInCommonToo) {
  const Transform turn = Transform::rotation_degrees({3, 1, 2}, 17);
  const Solid tool = transformed(slanted_tool(0.9), turn);
  const Solid result =
      boolean(transformed(block({-1, -1, -1}, {1, 1, 1}), turn), tool, Operation::unite);
  const Phases phases(result, tool, Operation::intersect);
  EXPECT_EQ(common_planes(phases.w), planes(phases.w.patch[Operand::b]).size());
  EXPECT_EQ(boolean(result, tool, Operation::intersect), tool);
}

// Their coefficients are no doubles, not even infinite ones.
TEST(EqualPlanes, ThoseOfSolidsAtTheEndOfTheDoublesAreFoundByTheirPoints) {
  const double large = 0x1p600;
  const Transform enlarge = Transform::scaling({large, large, large});
  const Solid tool = Solid::from_mesh(transformed(slanted_tool(0.9).to_mesh(), enlarge));
  const Solid beside = Solid::from_mesh(transformed(slanted_tool(0.8).to_mesh(), enlarge));
  const Solid result = boolean(
      boolean(block({-large, -large, -large}, {large, large, large}), tool, Operation::unite),
      beside, Operation::unite);
  const Phases phases(result, tool, Operation::intersect);
  EXPECT_EQ(common_planes(phases.w), planes(phases.w.patch[Operand::b]).size());
  EXPECT_EQ(boolean(result, tool, Operation::intersect), tool);
}

TEST(EqualPlanes, SmallOnesBesideThoseAreFoundAllTheSame) {
  const PolygonMesh corner = block({0, 0, 0}, {1, 1, 1}).to_mesh();
  const Solid endless =
      Solid::from_mesh(transformed(corner, Transform::scaling({0x1p600, 0x1p600, 0x1p600}) *
                                               Transform::rotation_degrees({1, 2, 3}, 25)));
  const Solid tool = slanted_tool(0.2);
  const Solid result = boolean(endless, tool, Operation::unite);
  EXPECT_GT(common_planes(Phases(result, tool, Operation::intersect).w), 0u);
  EXPECT_EQ(boolean(result, tool, Operation::intersect), tool);
  EXPECT_EQ(boolean(boolean(result, tool, Operation::subtract), tool, Operation::unite), result);
}

}  // namespace
}  // namespace sectile
