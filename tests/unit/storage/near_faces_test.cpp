// How many pairs of faces are looked at where boxes say nothing.
#include "storage/near_faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "cases.h"
#include "needles.h"
#include "sectile/boolean.h"
#include "sectile/primitives.h"
#include "sectile/validate.h"
#include "storage/cut_into_blocks.h"
#include "storage/solid_data.h"

namespace sectile {
namespace {

struct Counts {
  std::size_t boxes = 0, faces = 0;
};

Counts pairs(const Solid& a, const Solid& b) {
  Counts counts;
  NearFaces near;
  const auto none = [](std::uint32_t, std::uint32_t) { return false; };
  for (const Slot& s : a.data()->slots())
    for (const Slot& t : b.data()->slots()) {
      if (s.empty() || t.empty()) continue;
      BoxTree::overlaps(s.block->tree(), t.block->tree(),
                        [&](std::uint32_t, std::uint32_t) { ++counts.boxes; });
      near(
          *s.block, *t.block, [&](std::uint32_t, std::uint32_t) { ++counts.faces; }, none);
    }
  return counts;
}

TEST(NearFaces, NeedlesBesideEachOtherAreApart) {
  if (most_faces_of_a_block < 64) GTEST_SKIP() << "faces of so small blocks are all tested exactly";
  const Counts found = pairs(test::needles(400, 1, 1, 2), test::needles(300, 0.9, 1, -2));
  EXPECT_GT(found.boxes, 100'000u);
  EXPECT_LT(found.faces, 2'000u);  // the flat ends and what is next to them
}

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

Pairs pairs(NearFaces& near, const Slot& s, const Slot& t) {
  Pairs found;
  near(
      *s.block, *t.block,
      [&](std::uint32_t f, std::uint32_t g) {
        found.push_back({f, g});
      },
      [](std::uint32_t, std::uint32_t) { return false; });
  return found;
}

TEST(NearFaces, AreTheSameAfterOtherBlocksOfAllSizes) {
  const Solid ball = Solid::from_mesh(sphere_mesh({0, 0, 0}, 1, 60, 31)),
              dented = boolean(ball, Solid::from_mesh(sphere_mesh({0.9, 0.4, 0.2}, 0.7, 20, 11)),
                               Operation::subtract),
              larger = Solid::from_mesh(sphere_mesh({4, 0.5, 0.3}, 4, 80, 41));
  NearFaces used;
  std::size_t count = 0;
  for (const Slot& s : dented.data()->slots())
    for (const Slot& t : larger.data()->slots()) {
      if (s.empty() || t.empty()) continue;
      NearFaces fresh;
      const Pairs expected = pairs(fresh, s, t);
      EXPECT_EQ(pairs(used, s, t), expected);
      count += expected.size();
    }
  EXPECT_GT(count, 100u);
}

// How often a mesh of triangles winds around a point, by the solid angles of its triangles.
double winding(const PolygonMesh& mesh, const Vec3& around) {
  const auto corner = [&](std::size_t i) {
    const Vec3& p = mesh.positions[mesh.indices[i]];
    return Vec3{p.x - around.x, p.y - around.y, p.z - around.z};
  };
  const auto dot = [](const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; };
  double angle = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Vec3 a = corner(i), b = corner(i + 1), c = corner(i + 2);
    const double la = std::sqrt(dot(a, a)), lb = std::sqrt(dot(b, b)), lc = std::sqrt(dot(c, c));
    const Vec3 across{b.y * c.z - b.z * c.y, b.z * c.x - b.x * c.z, b.x * c.y - b.y * c.x};
    angle += 2 * std::atan2(dot(a, across),
                            la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  }
  return angle / (4 * std::numbers::pi);
}

TEST(NearFaces, NoPairThatMeetsIsLost) {
  const Solid a = test::needles(30, 1, 1, 2), b = test::needles(25, 1, 1, -2);
  const PolygonMesh mesh_a = a.to_mesh(), mesh_b = b.to_mesh();
  const Solid both = boolean(a, b, Operation::unite), inner = boolean(a, b, Operation::intersect);
  EXPECT_TRUE(validate(both).empty());
  EXPECT_TRUE(validate(inner).empty());
  const PolygonMesh mesh_both = both.to_mesh(), mesh_inner = inner.to_mesh();
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> anywhere(-1.1, 1.1);
  int in_one = 0;
  for (int i = 0; i < cases(500); ++i) {
    const Vec3 p{anywhere(engine), anywhere(engine), anywhere(engine)};
    const double in_a = winding(mesh_a, p), in_b = winding(mesh_b, p);
    EXPECT_NEAR(winding(mesh_both, p), std::max(in_a, in_b), 1e-9);
    EXPECT_NEAR(winding(mesh_inner, p), std::min(in_a, in_b), 1e-9);
    if (std::abs(in_a - in_b) > 0.5) ++in_one;
  }
  EXPECT_GT(in_one, cases(5));
}

}  // namespace
}  // namespace sectile
