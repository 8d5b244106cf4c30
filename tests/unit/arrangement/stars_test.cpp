// Stars: very many walls that begin in one point and stand on a floor. In its plane all their edges
// have that point in common, and some lie on each other.
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "append_mesh.h"
#include "sectile/sectile.h"
#include "unit/for_an_observer.h"
#include "unit/laws_of_sets.h"

namespace sectile {
namespace {

struct Spike {
  Vec2 left, right;
  double height;
  double volume() const { return 0.5 * height * (left.y * right.x - left.x * right.y); }
};

// On the plane z = 0, from the origin on.
PolygonMesh prism(const Spike& s) {
  PolygonMesh mesh{{}, {3, 3, 4, 4, 4}, {0, 2, 1, 3, 4, 5, 0, 1, 4, 3, 1, 2, 5, 4, 2, 0, 3, 5}};
  for (const double z : {0.0, s.height})
    for (const Vec2& p : {Vec2{0, 0}, s.right, s.left}) mesh.positions.push_back({p.x, p.y, z});
  return mesh;
}

// To the border of a square, one beside the other, each as wide as the gap to the next one.
std::vector<Spike> spikes_around(int side) {
  std::vector<Spike> spikes;
  for (int i = -side; i < side; i += 2) {
    const double a = i, b = i + 1, r = side;
    spikes.push_back({{b, -r}, {a, -r}, 1});
    spikes.push_back({{r, b}, {r, a}, 2});
    spikes.push_back({{-b, r}, {-a, r}, 3});
    spikes.push_back({{-r, -b}, {-r, -a}, 4});
  }
  for (Spike& s : spikes)
    if (s.volume() < 0) std::swap(s.left, s.right);
  return spikes;
}

Solid floor_below(double size) {
  return block({-size, -size, -1}, {size, size, 0});
}

// Of what reaches below a floor so thick.
double outside_of(const std::vector<Spike>& spikes, double thickness) {
  double sum = 0;
  for (const Spike& s : spikes)
    if (s.height > thickness) sum += s.volume() * (1 - thickness / s.height);
  return sum;
}

double volume_of(const std::vector<Spike>& spikes) {
  double sum = 0;
  for (const Spike& s : spikes) sum += s.volume();
  return sum;
}

TEST(Stars, OnAFloorAreCellsOfTheirOwn) {
  const std::vector<Spike> spikes = spikes_around(32);
  std::vector<Solid> parts{floor_below(40)};
  PolygonMesh all = parts[0].to_mesh();
  for (const Spike& s : spikes) {
    test::append(prism(s), all);
    parts.push_back(Solid::from_mesh(prism(s)));
  }
  const std::vector<SolidCell> found = cells(parts);
  ASSERT_EQ(found.size(), parts.size());
  for (const SolidCell& cell : found) {
    ASSERT_EQ(cell.operands.size(), 1u);
    EXPECT_EQ(cell.solid.volume(), parts[cell.operands[0]].volume());
  }
  EXPECT_NEAR(repair(all).volume(), 80 * 80 + volume_of(spikes), 1e-6);
}

// Long ones, and short ones in the same directions: each lies on a half of another one.
TEST(Stars, WithSpikesWithinEachOtherAreDividedByThem) {
  std::vector<Spike> spikes = spikes_around(16);
  const std::size_t count = spikes.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Spike& s = spikes[i];
    const Vec2 left{0.5 * s.left.x, 0.5 * s.left.y},
        middle{0.25 * (s.left.x + s.right.x), 0.25 * (s.left.y + s.right.y)};
    spikes.push_back({left, middle, s.height});
  }
  std::vector<Solid> parts{floor_below(20)};
  for (const Spike& s : spikes) parts.push_back(Solid::from_mesh(prism(s)));
  double once = 0, twice = 0;
  for (const SolidCell& cell : cells(parts))
    (cell.operands.size() == 1 ? once : twice) += cell.solid.volume();
  EXPECT_NEAR(twice, volume_of(spikes) - volume_of(spikes_around(16)), 1e-9);
  EXPECT_NEAR(once + twice, 40 * 40 + volume_of(spikes_around(16)), 1e-9);
}

Solid star_of(const std::vector<Spike>& spikes) {
  PolygonMesh all;
  for (const Spike& s : spikes) test::append(prism(s), all);
  return Solid::from_mesh(all);
}

TEST(Stars, OnAFloorAreOneWithIt) {
  const std::vector<Spike> spikes = spikes_around(32);
  const Solid star = star_of(spikes), floor = floor_below(40);
  EXPECT_NEAR(boolean(star, floor, Operation::unite).volume(), floor.volume() + volume_of(spikes),
              1e-6);
  EXPECT_TRUE(boolean(floor, star, Operation::subtract) == floor);
  EXPECT_TRUE(boolean(star, floor, Operation::intersect).is_empty());
  test::expect_the_same_for_an_observer(star, floor);
}

// Edges of the lower star that lie in faces of the upper one, where both are flush with the floor.
TEST(Stars, ThatTouchEachOtherOnAFloorAreOneWithIt) {
  std::vector<Spike> spikes = spikes_around(8);
  const Solid upper = star_of(spikes);
  std::vector<Spike> shorter;
  for (const Spike& s : spikes)
    shorter.push_back({{0.75 * s.left.x + 0.25 * s.right.x, 0.75 * s.left.y + 0.25 * s.right.y},
                       {0.5 * s.right.x, 0.5 * s.right.y},
                       s.height});
  const Solid lower = transformed(star_of(shorter), Transform::scaling({1, 1, -1}));
  const Solid both = boolean(upper, lower, Operation::unite), floor = floor_below(10),
              all = boolean(both, floor, Operation::unite);
  EXPECT_NEAR(all.volume(), floor.volume() + volume_of(spikes) + outside_of(shorter, 1), 1e-9);
  test::expect_laws_of_sets(both, floor);
  test::expect_the_same_for_an_observer(both, floor);
}

}  // namespace
}  // namespace sectile
