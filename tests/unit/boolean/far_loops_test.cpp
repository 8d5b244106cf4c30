// Faces with very many holes, of which an operation touches few: the others are neither loaded nor
// made anew.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <vector>

#include "cases.h"
#include "sectile/sectile.h"
#include "storage/solid_data.h"

namespace sectile {
namespace {

constexpr int columns = 8;
constexpr std::uint32_t sides = 12;
constexpr double radius = 0.25, thickness = 1;

Solid moved(const Solid& solid, double x, double y, double z = 0) {
  return transformed(solid, Transform::translation({x, y, z}));
}

Solid plate() {
  return block({0, 0, 0}, {columns, columns, thickness});
}

Solid drill(double x, double y) {
  return moved(cylinder(radius, 3, sides), x, y, -1);
}

std::vector<Solid> drills() {
  std::vector<Solid> all;
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < columns; ++j) all.push_back(drill(i + 0.5, j + 0.5));
  return all;
}

// All at one go.
Solid drilled() {
  const std::vector<Solid> all = drills();
  return subtract(plate(), all);
}

double volume_of_a_hole() {
  const double angle = 2 * std::numbers::pi / sides;
  return thickness * sides * radius * radius * std::sin(angle) / 2;
}

constexpr double volume_of_plate = columns * columns * thickness;

void expect_legal(const Solid& solid) {
  const std::vector<Violation> found = validate(solid);
  EXPECT_TRUE(found.empty()) << found.front().what;
}

Solid checked(const Solid& a, const Solid& b, Operation operation) {
  BooleanOptions options;
  options.validate = true;
  Solid result = boolean(a, b, operation, options);
  expect_legal(result);
  return result;
}

std::map<FaceSource, std::size_t> faces_by_source(const Solid& solid) {
  std::map<FaceSource, std::size_t> count;
  for (const FaceSource& source : solid.data()->brep().source) ++count[source];
  return count;
}

// The plate is cut before it has any hole, and then drilled at one go.
Solid cut_before_drilling(const Solid& tool) {
  const std::vector<Solid> all = drills();
  return subtract(boolean(plate(), tool, Operation::subtract), all);
}

void expect_same_as_cut_before_drilling(const Solid& tool) {
  const Solid cut = checked(drilled(), tool, Operation::subtract),
              expected = cut_before_drilling(tool);
  EXPECT_EQ(cut, expected);
  EXPECT_EQ(cut.counts().faces, expected.counts().faces);
  EXPECT_EQ(cut.counts().vertices, expected.counts().vertices);
  EXPECT_EQ(cut.counts().shells, expected.counts().shells);
  EXPECT_EQ(cut.counts().genus, expected.counts().genus);
  EXPECT_EQ(faces_by_source(cut).size(), faces_by_source(expected).size());
  // What is left of it can be drilled again.
  const Solid other_tool = drill(2.1, 5.9);
  EXPECT_EQ(checked(cut, other_tool, Operation::subtract),
            boolean(expected, other_tool, Operation::subtract));
}

TEST(FarLoops, HolesDrilledOneByOneInAnyOrder) {
  for (const unsigned seed : {1u, 2u}) {
    std::vector<Solid> all = drills();
    std::shuffle(all.begin(), all.end(), std::mt19937(seed));
    Solid solid = plate();
    for (const Solid& hole : all) solid = boolean(solid, hole, Operation::subtract);
    expect_legal(solid);
    const Solid at_once = subtract(plate(), all);
    EXPECT_EQ(solid, at_once);
    EXPECT_NEAR(solid.volume(), volume_of_plate - columns * columns * volume_of_a_hole(), 1e-9);
    EXPECT_EQ(solid.counts().faces, 6u + columns * columns * sides);
    EXPECT_EQ(solid.counts().genus, columns * columns);
    EXPECT_EQ(solid.counts().vertices, at_once.counts().vertices);
    EXPECT_EQ(solid.counts().edges, at_once.counts().edges);
  }
}

TEST(FarLoops, HolesInDoublesAreThoseOfAnExtrusion) {
  const auto circle = [](double x, double y) {
    Profile p;
    for (std::uint32_t i = 0; i < sides; ++i) {
      const double angle = 2 * std::numbers::pi * i / sides;
      p.outer.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle)});
    }
    return p;
  };
  Profile outline;
  outline.outer = {{0, 0}, {columns, 0}, {columns, columns}, {0, columns}};
  Solid solid = plate();
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < columns; ++j) {
      const Profile hole = circle(i + 0.5, j + 0.5);
      outline.holes.push_back(hole.outer);
      solid = boolean(solid, moved(extrude(hole, 3), 0, 0, -1), Operation::subtract);
    }
  EXPECT_EQ(solid, extrude(outline, thickness));
}

TEST(FarLoops, AHoleThatOverlapsAnother) {
  expect_same_as_cut_before_drilling(drill(3.8, 4.5));
}
TEST(FarLoops, AHoleThatOverlapsFour) {
  expect_same_as_cut_before_drilling(moved(cylinder(0.6, 3, sides), 4, 4, -1));
}
TEST(FarLoops, AHoleAcrossTheRim) {
  expect_same_as_cut_before_drilling(drill(0, 4));
}
TEST(FarLoops, AHoleInTheCorner) {
  expect_same_as_cut_before_drilling(drill(columns, columns));
}
TEST(FarLoops, AHoleInAHole) {
  const Solid solid = drilled();
  EXPECT_EQ(checked(solid, moved(cylinder(0.1, 3, sides), 2.5, 2.5, -1), Operation::subtract),
            solid);
}
TEST(FarLoops, AWiderHoleAroundAHole) {
  expect_same_as_cut_before_drilling(moved(cylinder(0.4, 3, sides), 2.5, 2.5, -1));
}
TEST(FarLoops, ABlindHole) {
  expect_same_as_cut_before_drilling(block({3.875, 3.875, 0.5}, {4.125, 4.125, 2}));
}
TEST(FarLoops, AChannelWithinThePlate) {
  expect_same_as_cut_before_drilling(block({-1, 4.375, 0.25}, {columns + 1, 4.625, 0.75}));
}
TEST(FarLoops, AHoleAcrossInTheSide) {
  expect_same_as_cut_before_drilling(block({-1, 3.9, 0.25}, {0.125, 4.1, 0.75}));
}
TEST(FarLoops, ASlotBetweenHolesThatDividesThePlate) {
  expect_same_as_cut_before_drilling(block({3.9375, -1, -1}, {4.0625, columns + 1, 2}));
}
TEST(FarLoops, ASlotThroughHolesThatDividesThePlate) {
  expect_same_as_cut_before_drilling(block({4.375, -1, -1}, {4.5, columns + 1, 2}));
}
TEST(FarLoops, ASlantedSlotThatDividesThePlate) {
  expect_same_as_cut_before_drilling(moved(transformed(block({-0.0625, -20, -1}, {0.0625, 20, 2}),
                                                       Transform::rotation_degrees({0, 0, 1}, 30)),
                                           4, 4));
}
TEST(FarLoops, ACrossThatDividesThePlateInFour) {
  expect_same_as_cut_before_drilling(boolean(block({3.9375, -1, -1}, {4.0625, columns + 1, 2}),
                                             block({-1, 3.9375, -1}, {columns + 1, 4.0625, 2}),
                                             Operation::unite));
}

Solid frame(double low, double high, double width, double bottom) {
  return boolean(block({low, low, bottom}, {high, high, 2}),
                 block({low + width, low + width, -2}, {high - width, high - width, 3}),
                 Operation::subtract);
}

// The box of the part outside holds the islands, and theirs the ones further inside.
TEST(FarLoops, FramesThatLeaveIslandsWithHoles) {
  expect_same_as_cut_before_drilling(frame(1.9375, 6.0625, 0.125, -1));
  const Solid frames =
      boolean(frame(0.9375, 7.0625, 0.125, -1), frame(2.9375, 5.0625, 0.125, -1), Operation::unite);
  expect_same_as_cut_before_drilling(frames);
}
TEST(FarLoops, AGrooveAroundHoles) {
  expect_same_as_cut_before_drilling(frame(1.9375, 6.0625, 0.125, 0.5));
}

TEST(FarLoops, PartsOfAPlateThatIsDividedAreCutFurther) {
  Solid solid = drilled();
  std::vector<Solid> tools = drills();
  for (int i = 0; i < 6; ++i) {
    const double at = i + 0.9375;
    tools.push_back(i % 2 == 0 ? block({at, -1, -1}, {at + 0.125, columns + 1, 2})
                               : block({-1, at, -1}, {columns + 1, at + 0.125, 2}));
    solid = checked(solid, tools.back(), Operation::subtract);
  }
  EXPECT_EQ(solid, subtract(plate(), tools));
  EXPECT_EQ(solid.counts().shells, 16u);
}

TEST(FarLoops, HalfOfThePlate) {
  const Solid half = block({-1, -1, -1}, {4, columns + 1, 2});
  const Solid solid = drilled(), left = checked(solid, half, Operation::intersect),
              right = checked(solid, half, Operation::subtract);
  EXPECT_NEAR(left.volume(), solid.volume() / 2, 1e-9);
  EXPECT_EQ(checked(left, right, Operation::unite), solid);
  EXPECT_EQ(checked(left, right, Operation::intersect), Solid());
}

TEST(FarLoops, OfAToolThatIsTakenAway) {
  const Solid solid = drilled(), stick = block({3.9, 3.9, -1}, {4.1, 4.1, 2});
  EXPECT_NEAR(checked(stick, solid, Operation::subtract).volume(), 0.08, 1e-9);
  const Solid pegs = checked(block({0, 0, 0}, {columns, columns, 0.5}), solid, Operation::subtract);
  EXPECT_EQ(pegs.counts().shells, std::size_t(columns * columns));
}

// What it is subtracted from has the plate's faces the other way round.
TEST(FarLoops, AMouldOfThePlate) {
  const Solid large = block({-1, -1, -1}, {columns + 1, columns + 1, 2});
  const Solid mould = checked(large, drilled(), Operation::subtract);
  const Solid hole = block({3.9, 3.9, -2}, {4.1, 4.1, 3});
  const Solid cut = checked(mould, hole, Operation::subtract);
  EXPECT_NEAR(cut.volume(), mould.volume() - 0.08, 1e-9);
  EXPECT_EQ(checked(large, cut, Operation::subtract),
            checked(drilled(), boolean(large, hole, Operation::intersect), Operation::unite));
}

TEST(FarLoops, ABossBetweenHoles) {
  const Solid boss = block({3.9, 3.9, thickness}, {4.1, 4.1, 2}), solid = drilled();
  const Solid with_boss = checked(solid, boss, Operation::unite);
  EXPECT_EQ(with_boss.counts().shells, 1u);
  EXPECT_NEAR(with_boss.volume(), solid.volume() + boss.volume(), 1e-9);
  EXPECT_EQ(checked(with_boss, boss, Operation::subtract), solid);
}

// Faces of one source become one face, with the far loops of both.
TEST(FarLoops, TwoPlatesSideBySideBecomeOne) {
  const Solid solid = drilled(), next = moved(solid, columns, 0);
  const Solid both = checked(solid, next, Operation::unite);
  EXPECT_EQ(both.counts().shells, 1u);
  EXPECT_EQ(both.counts().genus, 2 * columns * columns);
  EXPECT_NEAR(both.volume(), 2 * solid.volume(), 1e-9);
  EXPECT_EQ(checked(both, next, Operation::subtract), solid);
  EXPECT_EQ(checked(both, solid, Operation::subtract), next);
}

TEST(FarLoops, APlateThatIsDividedBecomesOneAgain) {
  const Solid gap = block({3.9375, -1, -1}, {4.0625, columns + 1, 2}), solid = drilled();
  const Solid halves = checked(solid, gap, Operation::subtract),
              filling = boolean(gap, plate(), Operation::intersect);
  EXPECT_EQ(checked(halves, filling, Operation::unite), solid);
}

// The parts into which a face falls become one face again.
TEST(FarLoops, APieceOfThePlateIsUnitedWithIt) {
  const Solid gap = block({3.9375, -1, -1}, {4.0625, columns + 1, 2}), solid = drilled();
  const Solid united = checked(solid, boolean(solid, gap, Operation::intersect), Operation::unite);
  EXPECT_EQ(united, solid);
  EXPECT_EQ(united.counts().faces, solid.counts().faces);
}

// Square holes that touch each other in corners, and in edges of their walls.
TEST(FarLoops, HolesThatTouchEachOther) {
  std::vector<Solid> squares;
  for (int i = 0; i < 2 * columns; ++i)
    for (int j = i % 2; j < 2 * columns; j += 2)
      squares.push_back(
          block({i / 2.0 + 0.25, j / 2.0 + 0.25, -1}, {i / 2.0 + 0.75, j / 2.0 + 0.75, 2}));
  const Solid large = block({0, 0, 0}, {columns + 0.5, columns + 0.5, thickness});
  Solid solid = large;
  std::vector<Solid> done;
  for (const Solid& square : squares) {
    solid = boolean(solid, square, Operation::subtract);
    done.push_back(square);
  }
  EXPECT_EQ(solid, subtract(large, done));
  expect_legal(solid);
  EXPECT_DOUBLE_EQ(solid.volume(), large.volume() - 0.25 * static_cast<double>(squares.size()));
  const Solid tool = block({-1, 4.5, -1}, {columns + 1, 4.625, 2});
  done.push_back(tool);
  EXPECT_EQ(checked(solid, tool, Operation::subtract), subtract(large, done));
}

void expect_halves(const Solid& solid, const HalfSpace& plane) {
  const auto [above, below] = split(solid, plane);
  expect_legal(above);
  expect_legal(below);
  EXPECT_NEAR(above.volume() + below.volume(), solid.volume(), 1e-9);
  EXPECT_EQ(boolean(above, below, Operation::unite), solid);
  EXPECT_EQ(boolean(solid, above, Operation::subtract), below);
}

TEST(FarLoops, APlateIsSplit) {
  const Solid solid = checked(drilled(), drill(4, 4), Operation::subtract);
  expect_halves(solid, {1, 0.25, 0, -4.75});
  expect_halves(solid, {1, 0, 0, -4.5});
  expect_halves(solid, {1, 0, 0, -4});
  expect_halves(solid, {0, 0, 1, -0.5});
  expect_halves(solid, {0.5, 0, 1, -2});
  expect_halves(solid, {1, 1, 0, -0.5});
}

TEST(FarLoops, HalvesOfAPlateAreSplitFurther) {
  std::vector<Solid> parts{drilled()};
  for (const HalfSpace& plane : {HalfSpace{1, 0, 0, -4}, {0, 1, 0, -3.875}, {1, 1, 0, -7}}) {
    std::vector<Solid> finer;
    for (const Solid& part : parts) {
      const auto [above, below] = split(part, plane);
      for (const Solid& half : {above, below})
        if (!half.is_empty()) finer.push_back(half);
    }
    parts = std::move(finer);
  }
  EXPECT_EQ(parts.size(), 7u);
  double volume = 0;
  for (const Solid& part : parts) {
    expect_legal(part);
    volume += part.volume();
  }
  EXPECT_NEAR(volume, drilled().volume(), 1e-9);
  EXPECT_EQ(unite(parts), drilled());
}

// Such a face is turned around, again and again, while it is drilled.
TEST(FarLoops, OfAMouldOfAMould) {
  const Solid large = block({-1, -1, -1}, {columns + 1, columns + 1, 2});
  std::vector<Solid> all = drills();
  Solid solid = drilled();
  for (int i = 0; i < 6; ++i) {
    const Solid hole = moved(cylinder(0.1, 5, sides), i + 1, 3, -2);
    solid = checked(checked(large, solid, Operation::subtract), hole,
                    i % 2 == 0 ? Operation::unite : Operation::subtract);
    all.push_back(hole);
  }
  EXPECT_EQ(boolean(solid, plate(), Operation::intersect), subtract(plate(), all));
}

// Both lids hold the pegs that were in the holes: one comes from the block, the other was turned.
TEST(FarLoops, AFaceThatWasTurnedAndOneThatWasNotBecomeOne) {
  const Solid solid = drilled();
  const Solid lid =
      boolean(checked(block({0, 0, -1}, {columns, columns, 2}), solid, Operation::subtract),
              block({0, 0, 0.5}, {columns, columns, 2}), Operation::intersect);
  EXPECT_EQ(lid.counts().genus, 0);
  const Transform over =
      Transform::translation({2 * columns, 0, 2}) * Transform::scaling({-1, 1, -1});
  const Solid beside = transformed(solid, over);  // its upper side lies in the plane of the lid's
  const Solid both = checked(lid, beside, Operation::unite);
  EXPECT_EQ(both.counts().shells, 1u);
  EXPECT_EQ(both.counts().genus, columns * columns);
  EXPECT_NEAR(both.volume(), lid.volume() + beside.volume(), 1e-9);
  EXPECT_LT(faces_by_source(both).size(), both.counts().faces);
  EXPECT_EQ(checked(both, beside, Operation::subtract), lid);
  EXPECT_EQ(checked(both, lid, Operation::subtract), beside);
}

// Those who follow the phases see all loops loaded.
TEST(FarLoops, RandomChainsAreTheSameWithAllLoopsLoaded) {
  struct Watch : Observer {
    void phase_done(Phase, const std::vector<TraceEvent>&) override {}
  } watch;
  BooleanOptions all_loops;
  all_loops.observer = &watch;
  std::mt19937 random(7);
  const auto any = [&](int below) { return static_cast<int>(random() % unsigned(below)); };
  for (int chain = 0; chain < cases(8); ++chain) {
    Solid solid = drilled();
    for (int step = 0; step < 6; ++step) {
      const double x = any(33) / 4.0, y = any(33) / 4.0;
      const Solid tools[] = {drill(x, y), block({x, -1, any(3) / 2.0}, {x + 0.375, columns + 1, 2}),
                             block({x - 1, y - 1, -1}, {x + 2, y + 2, 2}), moved(drilled(), x, 0)};
      const Solid& tool = tools[any(4)];
      const int what = any(5);
      if (what == 4) {
        const HalfSpace plane{1.0 * any(3), 1, any(2) * 0.5, -y};
        const auto halves = split(solid, plane), expected = split(solid, plane, all_loops);
        EXPECT_EQ(halves.first, expected.first);
        EXPECT_EQ(halves.second, expected.second);
        expect_legal(halves.first);
        expect_legal(halves.second);
        solid = any(2) == 0 || halves.second.is_empty() ? halves.first : halves.second;
        continue;
      }
      const auto operation = what == 3 ? Operation::subtract : static_cast<Operation>(what);
      const Solid &a = what == 3 ? tool : solid, &b = what == 3 ? solid : tool;
      const Solid result = checked(a, b, operation);
      EXPECT_EQ(result, boolean(a, b, operation, all_loops));
      if (!result.is_empty()) solid = result;
    }
  }
}

TEST(FarLoops, FacesKeepTheirSources) {
  const Solid bare = plate();
  std::vector<Solid> all = drills();
  Solid solid = bare;
  for (const Solid& hole : all) solid = boolean(solid, hole, Operation::subtract);
  EXPECT_EQ(faces_by_source(solid), faces_by_source(subtract(bare, all)));
}

TEST(FarLoops, SameBitsForAnyNumberOfThreads) {
  const Solid solid = drilled(),
              tool = boolean(frame(1.9375, 6.0625, 0.125, -1), drill(5, 3), Operation::unite);
  const auto cut_by = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return boolean(solid, tool, Operation::subtract);
  };
  const Solid one = cut_by(1);
  for (const std::size_t threads : {2u, 8u}) {
    const Solid many = cut_by(threads);
    EXPECT_EQ(many.data()->brep().next, one.data()->brep().next);
    EXPECT_EQ(many.data()->brep().origin, one.data()->brep().origin);
    EXPECT_EQ(many.data()->brep().point, one.data()->brep().point);
    EXPECT_EQ(many.data()->brep().plane, one.data()->brep().plane);
    const auto &p = many.data()->geometry().positions, &q = one.data()->geometry().positions;
    EXPECT_TRUE(std::ranges::equal(
        p, q, [](const Vec3& u, const Vec3& v) { return u.x == v.x && u.y == v.y && u.z == v.z; }));
  }
}

// What is milled away, over and over, leaves nothing behind.
TEST(FarLoops, PointsDoNotGrowWithTheNumberOfCuts) {
  const auto points = [](const Solid& s) {
    std::size_t count = 0;
    for (const Slot& slot : s.data()->slots())
      if (!slot.empty()) count += slot.block->geometry().positions.size();
    return count;
  };
  Solid solid = drilled();
  const std::size_t before = points(solid);
  for (int i = 0; i < 120; ++i)
    solid = boolean(solid, moved(cylinder(0.06 + 0.001 * i, 3, 40), 4, 4, -1), Operation::subtract);
  expect_legal(solid);
  EXPECT_EQ(solid.counts().genus, columns * columns + 1);
  EXPECT_LT(points(solid), 5 * before);
}

}  // namespace
}  // namespace sectile
