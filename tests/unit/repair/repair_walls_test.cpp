// Walls in one mesh that all have an edge on one line, each with ends of its own, on a floor in one
// of whose faces the line is.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <span>

#include "append_mesh.h"
#include "sectile/arrangement.h"
#include "sectile/repair.h"
#include "sectile/sectile.h"

namespace sectile {
namespace {

using Kind = RepairChange::Kind;

constexpr std::uint32_t walls = 60;

// Each over half of its part of a turn around the z-axis; none has a face in a plane along an axis.
PolygonMesh wall(std::uint32_t i) {
  const double step = 2 * std::numbers::pi / walls, a = step * (i + 0.25), b = step * (i + 0.75);
  PolygonMesh mesh;
  for (const double z : {7919 * i % walls * 0.01, 1 + 10007 * i % walls * 0.01}) {
    mesh.positions.push_back({0, 0, z});
    for (const double angle : {a, b})
      mesh.positions.push_back({std::cos(angle), std::sin(angle), z});
  }
  mesh.face_sizes = {3, 3, 4, 4, 4};
  mesh.indices = {0, 2, 1, 3, 4, 5, 0, 1, 4, 3, 1, 2, 5, 4, 2, 0, 3, 5};
  return mesh;
}

class Walls : public testing::Test {
 protected:
  Walls() {
    add(block({-2, -2, -1}, {2, 0, 3}).to_mesh());
    for (std::uint32_t i = 0; i < walls; ++i) add(wall(i));
  }

  void add(const PolygonMesh& part) {
    test::append(part, mesh_);
    solids_.push_back(Solid::from_mesh(part));
  }

  Solid repaired(Rule rule) {
    RepairOptions options;
    options.rule = rule;
    const Solid result = repair(mesh_, options, &report_);
    EXPECT_TRUE(validate(result).empty());
    return result;
  }

  // Of the floor and some walls, which do not overlap each other.
  static Solid either(const Solid& floor, std::span<const Solid> some) {
    const Solid all = unite(some);
    return boolean(boolean(floor, all, Operation::unite), boolean(floor, all, Operation::intersect),
                   Operation::subtract);
  }

  std::size_t count(Kind kind) const {
    std::size_t sum = 0;
    for (const RepairChange& change : report_.changes)
      if (change.kind == kind) sum += change.count;
    return sum;
  }

  PolygonMesh mesh_;
  std::vector<Solid> solids_;
  RepairReport report_;
};

TEST_F(Walls, DivideTheFloorAndNoOtherWalls) {
  EXPECT_EQ(repaired(Rule::odd), either(solids_[0], std::span(solids_).subspan(1)));
  EXPECT_EQ(count(Kind::divided_faces), 2u);  // two triangles
}

TEST_F(Walls, SomeOfThemTwice) {
  std::vector<Solid> once;
  for (std::uint32_t i = 0; i < walls; ++i)
    if (i % 3 == 0)
      add(wall(i));
    else
      once.push_back(solids_[1 + i]);
  EXPECT_EQ(repaired(Rule::odd), either(solids_[0], once));
}

// Each has its edge on the line in common with the one on the other side: no shell is apart.
TEST_F(Walls, OnBothSidesOfTheLine) {
  for (std::uint32_t i = 0; i < walls; ++i) {
    PolygonMesh other = wall(i);
    for (Vec3& p : other.positions) p = {-p.x, -p.y, p.z};
    add(other);
  }
  for (const Rule rule : {Rule::positive, Rule::nonzero}) EXPECT_EQ(repaired(rule), unite(solids_));
}

TEST_F(Walls, KeepTheirFacesWhereNothingElseIs) {
  std::vector<FaceSource> sources;
  repaired(Rule::odd).to_mesh(sources);
  std::set<std::uint32_t> used;
  for (const FaceSource& source : sources) used.insert(source.face);
  EXPECT_EQ(used.size(), mesh_.face_sizes.size());
}

}  // namespace
}  // namespace sectile
