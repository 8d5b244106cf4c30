// Shells within shells, where boxes say little: long ones aslant, beside each other.
#include <gtest/gtest.h>

#include "sectile/sectile.h"
#include "unit/import/cell_mesh.h"

namespace sectile {
namespace {

// With a square as base, all in one direction.
PolygonMesh slanted_prism(const Vec3& at, double width, double length) {
  std::vector<Vec3> corners;
  for (const double z : {0.0, length})
    for (const Vec2 p : {Vec2{0, 0}, Vec2{1, 0}, Vec2{1, 1}, Vec2{0, 1}})
      corners.push_back({at.x + width * p.x + z, at.y + width * p.y + 0.75 * z, at.z + z});
  return with_faces(
      corners,
      {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
}

struct Prism {
  Vec3 base;
  double width, length;
  PolygonMesh mesh() const { return slanted_prism(base, width, length); }
  double volume() const { return width * width * length; }
  // All around a unit away, also along x and y.
  Prism within() const { return {{base.x + 2, base.y + 1.75, base.z + 1}, width - 2, length - 2}; }
};

constexpr int count = 60;

// The boxes of the long ones hold those of shorter ones.
Prism outer(int i) {
  const double half = 40.0 * (i % 5 + 1);
  return {{10.0 * i - half, -0.75 * half, -half}, 8, 2 * half};
}

struct Shells {
  PolygonMesh mesh;
  double volume = 0;
};
// Each with a cavity in which there is an island. Of one prism, `wrong`, the cavity or the island
// is turned over.
Shells hollow_prisms(int wrong = -1, bool cavity = false) {
  Shells shells;
  for (int i = 0; i < count; ++i) {
    const Prism prism = outer(i), hole = prism.within(), island = hole.within();
    const bool is_wrong = i == wrong;
    shells.mesh = joined(shells.mesh, prism.mesh());
    shells.mesh = joined(shells.mesh, is_wrong && cavity ? hole.mesh() : turned_over(hole.mesh()));
    shells.mesh =
        joined(shells.mesh, is_wrong && !cavity ? turned_over(island.mesh()) : island.mesh());
    shells.volume += prism.volume() - hole.volume() + island.volume();
  }
  return shells;
}

ImportOptions trusted() {
  ImportOptions options;
  options.trusted = true;
  return options;
}

TEST(Nesting, LongShellsAslantWithCavitiesAndIslands) {
  const Shells shells = hollow_prisms();
  for (const ImportOptions& options : {ImportOptions(), trusted()}) {
    const Solid solid = Solid::from_mesh(shells.mesh, options);
    EXPECT_EQ(solid.counts().shells, 3u * count);
    EXPECT_EQ(solid.volume(), shells.volume);
  }
}

TEST(Nesting, OneOfThemThatIsTurnedOverIsFound) {
  for (const int wrong : {0, 7, 29, 31, 58, count - 1})
    for (const bool cavity : {false, true}) {
      const Shells shells = hollow_prisms(wrong, cavity);
      for (const ImportOptions& options : {ImportOptions(), trusted()}) try {
          Solid::from_mesh(shells.mesh, options);
          ADD_FAILURE() << "accepted: " << wrong << ' ' << cavity;
        } catch (const InvalidSolid& error) {
          EXPECT_EQ(error.face() / 18, static_cast<std::uint32_t>(wrong)) << error.what();
        }
    }
}

TEST(Nesting, OneThatIsInAnotherTwiceIsFound) {
  const Shells shells = hollow_prisms();
  const PolygonMesh more = outer(17).within().within().within().mesh();
  EXPECT_THROW(Solid::from_mesh(joined(shells.mesh, more)), InvalidSolid);
  EXPECT_THROW(Solid::from_mesh(joined(shells.mesh, more), trusted()), InvalidSolid);
}

}  // namespace
}  // namespace sectile
