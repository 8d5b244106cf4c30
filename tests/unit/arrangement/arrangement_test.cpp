// Any number of solids in one arrangement, against counted cells and pairwise Booleans.
#include "sectile/arrangement.h"

#include <gtest/gtest.h>

#include <random>

#include "cases.h"
#include "sectile/sectile.h"

namespace sectile {
namespace {

struct LatticeBox {
  int low[3], high[3];
  bool has(int x, int y, int z) const {
    return low[0] <= x && x < high[0] && low[1] <= y && y < high[1] && low[2] <= z && z < high[2];
  }
  Solid solid() const {
    return block({double(low[0]), double(low[1]), double(low[2])},
                 {double(high[0]), double(high[1]), double(high[2])});
  }
};

constexpr int size = 5;

LatticeBox random_box(std::mt19937& random) {
  LatticeBox box;
  for (int k = 0; k < 3; ++k) {
    box.low[k] = static_cast<int>(random() % (size - 1));
    box.high[k] = box.low[k] + 1 + static_cast<int>(random() % unsigned(size - box.low[k]));
    box.high[k] = std::min(box.high[k], size);
  }
  return box;
}

template <class In>
double count(const In& in) {
  double sum = 0;
  for (int x = 0; x < size; ++x)
    for (int y = 0; y < size; ++y)
      for (int z = 0; z < size; ++z) sum += in(x, y, z);
  return sum;
}

TEST(Arrangement, RandomBoxesAreWhatTheirCellsSay) {
  std::mt19937 random(1);
  for (int round = 0; round < cases(400); ++round) {
    SCOPED_TRACE(round);
    const std::size_t boxes = 2 + random() % 6;
    std::vector<LatticeBox> box;
    std::vector<Solid> solids;
    for (std::size_t i = 0; i < boxes; ++i) {
      box.push_back(random_box(random));
      solids.push_back(box.back().solid());
    }
    const auto covering = [&](int x, int y, int z) {
      std::size_t n = 0;
      for (const LatticeBox& b : box) n += b.has(x, y, z);
      return n;
    };
    const Solid all = unite(solids), common = intersect(solids),
                first = subtract(solids[0], std::span(solids).subspan(1));
    EXPECT_EQ(all.volume(), count([&](int x, int y, int z) { return covering(x, y, z) > 0; }));
    EXPECT_EQ(common.volume(),
              count([&](int x, int y, int z) { return covering(x, y, z) == boxes; }));
    EXPECT_EQ(first.volume(), count([&](int x, int y, int z) {
                return box[0].has(x, y, z) && covering(x, y, z) == 1;
              }));
    for (const Solid& s : {all, common, first}) {
      const auto found = validate(s);
      EXPECT_TRUE(found.empty()) << found.front().what;
    }
    Solid pairwise_all = solids[0], pairwise_common = solids[0], pairwise_first = solids[0];
    for (std::size_t i = 1; i < boxes; ++i) {
      pairwise_all = boolean(pairwise_all, solids[i], Operation::unite);
      pairwise_common = boolean(pairwise_common, solids[i], Operation::intersect);
      pairwise_first = boolean(pairwise_first, solids[i], Operation::subtract);
    }
    EXPECT_TRUE(all == pairwise_all);
    EXPECT_TRUE(common == pairwise_common);
    EXPECT_TRUE(first == pairwise_first);
    double sum = 0;
    for (const SolidCell& cell : cells(solids)) {
      sum += cell.solid.volume();
      EXPECT_TRUE(validate(cell.solid).empty());
    }
    EXPECT_EQ(sum, all.volume());
  }
}

TEST(Arrangement, SolidsThatWereTurned) {
  const Solid cube = block({0, 0, 0}, {1, 1, 1});
  std::vector<Solid> solids;
  for (const double degrees : {0.0, 10.0, 37.0})
    solids.push_back(transformed(cube, Transform::rotation_degrees({1, 2, 3}, degrees)));
  Solid pairwise = solids[0];
  for (std::size_t i = 1; i < solids.size(); ++i)
    pairwise = boolean(pairwise, solids[i], Operation::unite);
  EXPECT_TRUE(unite(solids) == pairwise);
}

std::vector<Solid> random_spheres(unsigned seed, int count) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0, 4);
  const Solid ball = sphere(1, 12, 6);
  std::vector<Solid> spheres;
  for (int i = 0; i < count; ++i)
    spheres.push_back(
        transformed(ball, Transform::translation({place(random), place(random), place(random)})));
  return spheres;
}

TEST(Arrangement, ManySpheresAreWhatPairwiseBooleansMake) {
  const std::vector<Solid> spheres = random_spheres(3, 60);
  Solid pairwise = spheres[0];
  for (std::size_t i = 1; i < spheres.size(); ++i)
    pairwise = boolean(pairwise, spheres[i], Operation::unite);
  const Solid all = unite(spheres);
  EXPECT_TRUE(all == pairwise);
  EXPECT_TRUE(validate(all).empty());
  double sum = 0;
  for (const SolidCell& cell : cells(std::span(spheres).first(12))) sum += cell.solid.volume();
  EXPECT_NEAR(sum, unite(std::span(spheres).first(12)).volume(), 1e-10);
}

// A notch reaches the bottom in an edge: the bottom's loop runs along it from the rim and back.
TEST(Arrangement, BlocksOnAFaceWithASlitFromItsRim) {
  const Transform upright{{0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0}};
  const Solid notch = transformed(extrude({{{1, 0}, {1.5, 1}, {0.5, 1}}, {}}, 2), upright);
  const Solid body = boolean(block({0, 0, 0}, {3, 3, 1}), notch, Operation::subtract);
  EXPECT_EQ(body.volume(), 8);
  for (const Solid& other : {block({0.5, 1, 0}, {2.5, 2, 0.5}), block({0.5, 0, -1}, {2.5, 1, 0}),
                             block({0, 1, 0}, {3, 4, 1}), block({-1, 0.5, 0}, {1, 1.5, 1})}) {
    const Solid both[] = {body, other};
    double sum = 0;
    for (const SolidCell& cell : cells(both)) {
      sum += cell.solid.volume();
      const bool in_both = cell.operands.size() == 2;
      EXPECT_EQ(cell.solid, in_both                 ? boolean(body, other, Operation::intersect)
                            : cell.operands[0] == 0 ? boolean(body, other, Operation::subtract)
                                                    : boolean(other, body, Operation::subtract));
    }
    EXPECT_EQ(sum, boolean(body, other, Operation::unite).volume());
  }
}

TEST(Arrangement, EmptyAndFarOperands) {
  const Solid cube = block({0, 0, 0}, {2, 2, 2}), far = block({5, 5, 5}, {6, 6, 6}),
              corner = block({1, 1, 1}, {3, 3, 3});
  const std::vector<Solid> with_empty{cube, Solid(), corner};
  EXPECT_TRUE(unite(with_empty) == boolean(cube, corner, Operation::unite));
  EXPECT_TRUE(intersect(with_empty).is_empty());
  EXPECT_TRUE(intersect(std::vector<Solid>{cube, far, corner}).is_empty());
  EXPECT_TRUE(intersect(std::vector<Solid>{cube, corner}) == block({1, 1, 1}, {2, 2, 2}));
  EXPECT_TRUE(subtract(cube, std::vector<Solid>{far, Solid()}) == cube);
  EXPECT_TRUE(subtract(cube, std::vector<Solid>{far, corner}) ==
              boolean(cube, corner, Operation::subtract));
  EXPECT_TRUE(subtract(Solid(), std::vector<Solid>{cube}).is_empty());
  EXPECT_TRUE(unite({}).is_empty());
  EXPECT_TRUE(intersect({}).is_empty());
  EXPECT_TRUE(unite(std::vector<Solid>{far}) == far);
}

}  // namespace
}  // namespace sectile
