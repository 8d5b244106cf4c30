// Large meshes of triangles are repaired on a shorter way where each of their shells is a solid.
// What comes out, and what is said, is the same as on the way for all others.
#include <gtest/gtest.h>

#include "sectile/sectile.h"
#include "unit/large_meshes.h"

namespace sectile {
namespace {

PolygonMesh moved(PolygonMesh mesh, const Vec3& by, double size = 1) {
  for (Vec3& p : mesh.positions) p = {size * p.x + by.x, size * p.y + by.y, size * p.z + by.z};
  return mesh;
}

PolygonMesh inside_out(PolygonMesh mesh) {
  std::reverse(mesh.indices.begin(), mesh.indices.end());
  return mesh;
}

struct Repaired {
  Solid solid;
  std::vector<std::string> said;
};

Repaired repaired(const PolygonMesh& mesh, Rule rule) {
  RepairReport report;
  RepairOptions options;
  options.rule = rule;
  Repaired made{repair(mesh, options, &report), {}};
  for (const RepairChange& change : report.changes)
    if (change.kind != RepairChange::Kind::removed_flat) made.said.push_back(in_words(change));
  return made;
}

Solid expect_same_both_ways(const PolygonMesh& mesh) {
  Solid by_default;
  for (const Rule rule : {Rule::positive, Rule::nonzero, Rule::odd}) {
    SCOPED_TRACE(static_cast<int>(rule));
    const Repaired shorter = repaired(mesh, rule),
                   general = repaired(with_face_without_area(mesh), rule);
    EXPECT_TRUE(validate(shorter.solid).empty());
    EXPECT_TRUE(shorter.solid == general.solid);
    EXPECT_EQ(shorter.said, general.said);
    if (rule == Rule::positive) by_default = shorter.solid;
  }
  return by_default;
}

Solid united(const PolygonMesh& a, const PolygonMesh& b) {
  return boolean(Solid::from_mesh(a), Solid::from_mesh(b), Operation::unite);
}

TEST(RepairLarge, AMeshThatIsRightIsTakenAsItIs) {
  for (const PolygonMesh& mesh : {ball(), boulder(1.0 / 256), flattened_ball(), ring()}) {
    EXPECT_TRUE(expect_same_both_ways(mesh) == Solid::from_mesh(mesh));
    EXPECT_TRUE(repaired(mesh, Rule::positive).said.empty());
  }
}

TEST(RepairLarge, CornersOfTheirOwnAreCounted) {
  const PolygonMesh soup = soup_of(boulder(0));
  EXPECT_TRUE(expect_same_both_ways(soup) == Solid::from_mesh(boulder(0)));
  EXPECT_EQ(repaired(soup, Rule::positive).said.size(), 1u);
}

TEST(RepairLarge, ShellsThatCrossAreUnited) {
  const PolygonMesh a = boulder(0), b = moved(boulder(0), {0.7, 0.2, 0.1});
  EXPECT_TRUE(expect_same_both_ways(both(a, b)) == united(a, b));
}

TEST(RepairLarge, ShellsOfTrianglesInAnyOrder) {
  const PolygonMesh a = boulder(0), b = moved(ring(), {0.7, 0.2, 0.1});
  EXPECT_TRUE(expect_same_both_ways(soup_of(both(a, b))) == united(a, b));
}

TEST(RepairLarge, FourShells) {
  PolygonMesh mesh = ball();
  for (const Vec3& at : {Vec3{1, 0, 0}, Vec3{0, 1, 0.3}, Vec3{9, 9, 9}})
    mesh = both(mesh, moved(boulder(0), at, 0.6));
  EXPECT_EQ(expect_same_both_ways(mesh).counts().shells, 2u);
}

TEST(RepairLarge, ShellsApart) {
  const PolygonMesh a = boulder(0), b = moved(ball(), {5, 0, 0});
  EXPECT_TRUE(expect_same_both_ways(both(a, b)) == united(a, b));
}

TEST(RepairLarge, AShellWithinAnother) {
  const PolygonMesh inner = moved(ball(), {0.1, 0, 0}, 0.5);
  EXPECT_TRUE(expect_same_both_ways(both(ball(), inner)) == Solid::from_mesh(ball()));
  EXPECT_EQ(expect_same_both_ways(both(ball(), inside_out(inner))).counts().shells, 2u);
}

TEST(RepairLarge, TheSameShellTwice) {
  EXPECT_TRUE(expect_same_both_ways(both(ball(), moved(ball(), {0, 0, 1e-9}))) ==
              united(ball(), moved(ball(), {0, 0, 1e-9})));
  EXPECT_TRUE(expect_same_both_ways(both(ball(), ball())) == Solid::from_mesh(ball()));
}

// The flat sides lie on each other in part.
TEST(RepairLarge, ShellsThatTouchInFaces) {
  PolygonMesh mirrored = inside_out(flattened_ball());
  for (Vec3& p : mirrored.positions) p = {1.8 - p.x, p.y + 0.2, p.z};
  const Solid solid = expect_same_both_ways(both(flattened_ball(), mirrored));
  EXPECT_TRUE(solid == united(flattened_ball(), mirrored));
  EXPECT_EQ(solid.counts().shells, 1u);
}

TEST(RepairLarge, ShellsThatTouchInAPoint) {
  const auto spindle = [](double z) {
    return tube(48, 50, true, [z](double u, double v) {
      const double b = 2 * std::numbers::pi * v, r = 4 * u * (1 - u);
      return Vec3{r * std::cos(b), r * std::sin(b), z + 1 - 2 * u};
    });
  };
  EXPECT_TRUE(expect_same_both_ways(both(spindle(0), spindle(2))) ==
              united(spindle(0), spindle(2)));
}

TEST(RepairLarge, AShellThatCrossesItself) {
  PolygonMesh crossing = boulder(0);
  crossing.positions[1234].x += 3;
  expect_same_both_ways(crossing);
  expect_same_both_ways(both(crossing, moved(ball(), {0.5, 0.5, 0})));
}

TEST(RepairLarge, InsideOut) {
  EXPECT_TRUE(expect_same_both_ways(inside_out(boulder(0))) == Solid::from_mesh(boulder(0)));
}

TEST(RepairLarge, ProgressRisesToItsEnd) {
  PolygonMesh crossing = boulder(0);
  crossing.positions[1234].x += 3;
  for (const PolygonMesh& mesh :
       {boulder(0), both(ball(), moved(ball(), {0.5, 0.5, 0})), crossing}) {
    double last = 0;
    RepairOptions options;
    options.progress = [&](double done) {
      EXPECT_GE(done, last);
      last = done;
    };
    repair(mesh, options);
    EXPECT_EQ(last, 1);
  }
}

}  // namespace
}  // namespace sectile
