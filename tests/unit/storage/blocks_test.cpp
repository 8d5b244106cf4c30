// Solids share what no contact touches: blocks of neighbouring faces.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "boolean/boolean.h"
#include "sectile/sectile.h"
#include "storage/cut_into_blocks.h"
#include "topology/links.h"

namespace sectile {
namespace {

Solid ball(const Vec3& centre, double radius, std::uint32_t segments, std::uint32_t rings) {
  return Solid::from_mesh(sphere_mesh(centre, radius, segments, rings));
}

Solid many_faces() {
  return ball({0, 0, 0}, 1, 100, 101);  // 20,000 triangles
}

std::set<const Block*> blocks(const Solid& solid) {
  std::set<const Block*> found;
  for (const Slot& slot : solid.data()->slots())
    if (!slot.empty()) found.insert(slot.block.get());
  return found;
}

std::size_t shared(const Solid& a, const Solid& b) {
  const std::set<const Block*> mine = blocks(a), others = blocks(b);
  return static_cast<std::size_t>(std::count_if(
      mine.begin(), mine.end(), [&](const Block* block) { return others.contains(block); }));
}

// Those of few faces are made anew, lest they become many.
std::size_t large_blocks(const Solid& solid) {
  const std::set<const Block*> all = blocks(solid);
  return static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [](const Block* block) {
    return block->brep().face_count() >= few_faces;
  }));
}

// One block may have few faces; up to seven of eight slots may be empty.
void expect_few_blocks(const Solid& solid) {
  EXPECT_LE(blocks(solid).size(), solid.counts().faces / few_faces + 1);
  EXPECT_LE(solid.data()->slots().size(), 8 * blocks(solid).size());
}

void expect_legal(const Solid& solid) {
  EXPECT_TRUE(broken_links(solid.data()->brep(), false).empty());
  const std::vector<Violation> found = validate(solid);
  EXPECT_TRUE(found.empty()) << found.front().what;
}

TEST(Blocks, ALargeBoundaryIsCutAndJoinedAgain) {
  const Solid solid = many_faces();
  EXPECT_GT(blocks(solid).size(), 50u);
  const SolidCounts counts = solid.counts();
  EXPECT_EQ(solid.to_mesh().face_sizes.size(), 20000u);
  // Some triangles happen to be coplanar, and are one face.
  EXPECT_GT(counts.faces, 19000u);
  EXPECT_EQ(counts.vertices + counts.faces, counts.edges + 2);
  EXPECT_EQ(counts.vertices, 10002u);
  EXPECT_EQ(counts.shells, 1u);
  EXPECT_EQ(counts.genus, 0);
  expect_legal(solid);
}

// Block by block, the mesh is that of the boundary: where it was moved to, and with the material on
// its side.
TEST(Blocks, GiveTheMeshOfMovedAndMirroredSolids) {
  const Solid body = boolean(many_faces(), ball({0.9, 0, 0}, 0.4, 40, 21), Operation::subtract);
  const Solid exact = Solid::from_mesh(rounded_mesh(body).mesh);
  ASSERT_GT(blocks(exact).size(), 10u);
  for (const Vec3& by : {Vec3{2, 2, 2}, Vec3{-1, 1, 4}, Vec3{-2, -1, -0.5}}) {
    const Solid image = transformed(exact, Transform::scaling(by));
    std::vector<FaceSource> sources;
    const PolygonMesh mesh = image.to_mesh(sources);
    EXPECT_EQ(Solid::from_mesh(mesh), image);
    EXPECT_EQ(mesh.positions.size(), image.counts().vertices);
    EXPECT_EQ(sources.size(), mesh.face_sizes.size());
  }
}

TEST(Blocks, EdgesBetweenBlocksKnowEachOther) {
  const Solid solid = many_faces();
  const SolidData& data = *solid.data();
  std::size_t borders = 0;
  for (std::uint32_t s = 0; s < data.slots().size(); ++s)
    for (std::uint32_t e = 0; !data.slot(s).empty() && e < data.slot(s).block->border_count; ++e) {
      const HalfEdgeId h(2 * e);
      const auto there = data.across(s, h);
      ASSERT_NE(there.slot, s);
      const auto back = data.across(there.slot, there.local);
      EXPECT_EQ(back.slot, s);
      EXPECT_EQ(back.local, h);
      const auto position = [&](std::uint32_t slot, VertexId v) {
        const Block& block = *data.slot(slot).block;
        return block.geometry().position(block.brep().point_of(v));
      };
      EXPECT_EQ(position(s, data.slot(s).from(h)),
                position(there.slot, data.slot(there.slot).to(there.local)));
      ++borders;
    }
  EXPECT_GT(borders, 1000u);
}

TEST(Blocks, AResultSharesWhatAToolDoesNotTouch) {
  const Solid body = many_faces(), tool = ball({1, 0, 0}, 0.1, 12, 9);
  for (const Operation operation : {Operation::unite, Operation::subtract}) {
    const Solid result = boolean(body, tool, operation);
    EXPECT_GT(10 * shared(result, body), 9 * blocks(body).size());
    expect_legal(result);
  }
}

// The faces of a slot's block, by where they come from.
std::set<std::pair<std::uint32_t, std::uint32_t>> sources(const Slot& slot) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> found;
  for (const FaceSource& source : slot.block->brep().source)
    found.insert({source.solid, source.face});
  return found;
}

TEST(Blocks, OfATouchedBlockTheFacesThatNothingTouchesKeepTheirSlot) {
  const Solid body = many_faces(), tool = ball({1, 0, 0}, 0.1, 12, 9);
  const Solid result = boolean(body, tool, Operation::subtract);
  std::size_t trimmed = 0;
  for (std::uint32_t s = 0; s < body.data()->slots().size(); ++s) {
    const Slot &before = body.data()->slot(s), &after = result.data()->slot(s);
    if (after.empty() || after.block == before.block) continue;
    const auto all = sources(before), left = sources(after);
    if (left.size() < all.size() && std::includes(all.begin(), all.end(), left.begin(), left.end()))
      ++trimmed;
  }
  EXPECT_GE(trimmed, few_faces > 2 ? 2u : 0u);  // little is left of the small blocks for tests
  expect_legal(result);
}

Solid in_one_block(const Solid& solid) {
  const std::shared_ptr<const Block> whole(solid.data(), &solid.data()->whole());
  return Solid(std::make_shared<SolidData>(std::vector<Slot>{{whole, nullptr}}, true));
}

// Blocks beyond the other solid's box are not looked at. What lies within it may hang together with
// what the solids have in common by way of these only, or not at all.
TEST(Blocks, WhatIsFarFromTheOtherSolidIsOutsideOfIt) {
  const Solid body = ball({0, 0, 0}, 1, 40, 41);
  const Solid bodies[] = {body, boolean(body, ball({0, 0, 0}, 0.5, 30, 31), Operation::subtract),
                          boolean(body, ball({1.5, 1.5, 0}, 0.4, 30, 31), Operation::unite)};
  const Solid needle = extrude({{{-1.9, 2}, {-2, 1.9}, {0.2, -0.1}}, {}}, 0.1);
  const Solid tools[] = {ball({1, 0, 0}, 0.1, 12, 9), ball({0.3, 0, 0}, 0.9, 30, 31),
                         ball({3, 0, 0}, 1, 30, 31), ball({1.5, 1.5, 0}, 0.1, 12, 9), needle};
  for (const Solid& a : bodies)
    for (const Solid& b : tools)
      for (const Operation operation :
           {Operation::unite, Operation::intersect, Operation::subtract}) {
        const Solid result = boolean(a, b, operation);
        const Solid expected = boolean(in_one_block(a), in_one_block(b), operation);
        EXPECT_EQ(result, expected);
        EXPECT_EQ(result.counts().shells, expected.counts().shells);
        EXPECT_TRUE(broken_links(result.data()->brep(), false).empty());
      }
}

// Around an edge at which two parts touch, each part is a wedge of material. What is left of a
// block without them has wedges between these, and hangs together along the edge as the parts do
// not.
TEST(Blocks, WhereWhatIsTakenAwayTouchesItselfItsEdgesArePairedAnew) {
  const auto with_ball = [](const Vec3& low, const Vec3& high, const Vec3& centre) {
    return boolean(block(low, high), ball(centre, 0.5, 60, 61), Operation::unite);
  };
  const Solid parts = boolean(with_ball({0, 0, 0}, {1, 1, 1}, {0.2, 0.1, 0.3}),
                              with_ball({1, 1, 0}, {2, 2, 1}, {1.8, 1.9, 0.3}), Operation::unite);
  ASSERT_EQ(parts.counts().shells, 2u);
  ASSERT_GT(parts.data()->slots().size(), 10u);
  EXPECT_LT(parts.data()->touching_slots().size(), parts.data()->slots().size());
  const Solid around = block({-3, -3, -3}, {4, 4, 4}),
              corner = block({0.9, 0.9, 0.5}, {1.1, 1.1, 2});
  const Transform turn = Transform::rotation_degrees({1, 2, 3}, 40);
  for (const Solid& taken : {parts, transformed(parts, turn),
                             boolean(parts, ball({0, 0, 0}, 0.2, 30, 31), Operation::subtract)}) {
    const Solid mould = boolean(around, taken, Operation::subtract);
    EXPECT_EQ(mould.counts().shells, 2u);
    EXPECT_EQ(mould, boolean(in_one_block(around), in_one_block(taken), Operation::subtract));
    EXPECT_GE(shared(mould, taken), large_blocks(taken) - taken.data()->touching_slots().size());
    EXPECT_TRUE(broken_links(mould.data()->brep(), false).empty());
    EXPECT_EQ(boolean(around, mould, Operation::subtract).counts().shells, 2u);
  }
  EXPECT_EQ(
      boolean(corner, parts, Operation::subtract),
      boolean(corner, unite(std::vector{block({0, 0, 0}, {1, 1, 1}), block({1, 1, 0}, {2, 2, 1})}),
              Operation::subtract));
}

// The cavity's vertices at the ends of the edge are one each, with two edges between them.
TEST(Blocks, WhatIsLeftOfABlockWithoutWhatIsLeftOfItWithoutTwoCubesIsTheTwoCubes) {
  const Solid cubes =
      boolean(block({0, 0, 0}, {1, 1, 1}), block({1, 1, 0}, {2, 2, 1}), Operation::unite);
  for (const Vec3& low : {Vec3{-1, -1, -1}, Vec3{0, -1, -1}, Vec3{-1, -1, 0}, Vec3{0, 0, 0}}) {
    const Solid around = block(low, {3, 3, 3}), larger = block({-2, -2, -2}, {4, 4, 4});
    const Solid mould = boolean(around, cubes, Operation::subtract);
    const Solid back = boolean(around, mould, Operation::subtract);
    EXPECT_EQ(back.counts().shells, 2u);
    EXPECT_EQ(back.counts().vertices, 16u);
    EXPECT_EQ(back, cubes);
    const Solid filled = boolean(boolean(larger, mould, Operation::subtract),
                                 boolean(larger, around, Operation::subtract), Operation::subtract);
    EXPECT_EQ(filled.counts().shells, 2u);
    EXPECT_EQ(filled, cubes);
  }
}

// What was loaded of the second solid, and what was not, had points of their own for the place
// where the boxes touch: it was not seen that edges there lie at one place.
TEST(Blocks, PlacesWhereBoxesTouchHaveOnePointWhereNotAllOfASmallSolidIsLoaded) {
  const Solid boxes = unite(std::vector{block({2, 1, 1}, {3, 3, 3}), block({3, 0, 2}, {5, 3, 4}),
                                        block({2, 3, 3}, {4, 4, 6}), block({1, 0, 3}, {2, 3, 6})});
  const Solid around = block({0, 0, 0}, {9, 9, 9});
  const Solid mould = boolean(around, boxes, Operation::subtract);
  EXPECT_EQ(boxes.counts().shells, 2u);
  EXPECT_EQ(boolean(around, mould, Operation::subtract).counts().shells, 2u);
}

TEST(Blocks, WhatIsTakenAwayIsSharedTurnedInsideOut) {
  const Solid body = ball({0, 0, 0}, 2, 100, 101), cavity = many_faces();
  const Solid hollow = boolean(body, cavity, Operation::subtract);
  EXPECT_GE(shared(hollow, cavity), large_blocks(cavity));
  EXPECT_GE(shared(hollow, body), large_blocks(body));
  EXPECT_GT(large_blocks(cavity), 100u);
  EXPECT_EQ(hollow.counts().shells, 2u);
  EXPECT_NEAR(hollow.volume(), body.volume() - cavity.volume(), 1e-12);
  expect_legal(hollow);
  // And once more: what is filled again is the body.
  EXPECT_EQ(boolean(hollow, cavity, Operation::unite), body);
  EXPECT_EQ(boolean(body, hollow, Operation::subtract), cavity);
}

TEST(Blocks, ACutThroughATurnedShell) {
  const Solid hollow =
      boolean(ball({0, 0, 0}, 2, 60, 61), ball({0, 0, 0}, 1, 60, 61), Operation::subtract);
  const auto [above, below] = split(hollow, {1, 2, 3, 0.1});
  expect_legal(above);
  expect_legal(below);
  EXPECT_NEAR(above.volume() + below.volume(), hollow.volume(), 1e-9);
  EXPECT_EQ(boolean(above, below, Operation::unite), hollow);
}

TEST(Blocks, ASmallPieceOfALargeSolidIsSmall) {
  const Solid piece = boolean(many_faces(), ball({1, 0, 0}, 0.1, 12, 9), Operation::intersect);
  expect_few_blocks(piece);
  expect_legal(piece);
}

TEST(Blocks, LongChainsDoNotLeaveManySmallBlocks) {
  Solid row = block({0, 0, 0}, {1, 1, 1});
  for (int i = 1; i < 300; ++i)
    row = boolean(row, block({2.0 * i, 0, 0}, {2.0 * i + 1, 1, 1}), Operation::unite);
  EXPECT_EQ(row.counts().shells, 300u);
  expect_few_blocks(row);
  Solid body = many_faces();
  const std::size_t before = body.data()->slots().size();
  for (int i = 0; i < 60; ++i) {
    const double angle = 0.1 * i;
    body =
        boolean(body, ball({std::cos(angle), std::sin(angle), 0}, 0.07, 8, 7), Operation::subtract);
  }
  EXPECT_LT(body.data()->slots().size(), 2 * before);
  expect_legal(body);
}

// Two opposite quarters of a cube touch in an edge whose ends are points in which planes meet.
TEST(Blocks, WhatTouchesItselfWherePlanesMeet) {
  const auto [front, back] = split(block({-1, -1, -1}, {1, 1, 1}), {-0.2, 1, 0.2, -0.05});
  const HalfSpace side{1, 0.3, 0.1, -0.05};
  const Solid one = split(front, side).first, other = split(back, side).second;
  const Solid both = boolean(one, other, Operation::unite);
  const Solid corner = block({-1, -1, -1.5}, {0, 0, -0.5});
  EXPECT_EQ(boolean(corner, both, Operation::subtract),
            boolean(boolean(corner, one, Operation::subtract), other, Operation::subtract));
  EXPECT_EQ(boolean(both, corner, Operation::subtract),
            boolean(boolean(one, corner, Operation::subtract),
                    boolean(other, corner, Operation::subtract), Operation::unite));
}

TEST(Blocks, ASolidMinusItselfIsEmpty) {
  const Solid solid = many_faces();
  EXPECT_TRUE(boolean_by_cutting(solid, solid, Operation::subtract, {}).is_empty());
  EXPECT_EQ(boolean_by_cutting(solid, solid, Operation::unite, {}), solid);
}

TEST(Blocks, ATracedOperationNamesEntitiesOfTheWholeSolid) {
  struct Watch : Observer {
    std::size_t events = 0;
    void phase_done(Phase, const std::vector<TraceEvent>& some) override { events += some.size(); }
  } watch;
  BooleanOptions options;
  options.observer = &watch;
  const Solid body = many_faces(), tool = ball({1, 0, 0}, 0.1, 12, 9);
  EXPECT_EQ(boolean(body, tool, Operation::subtract, options),
            boolean(body, tool, Operation::subtract));
  EXPECT_GT(watch.events, 100u);
}

}  // namespace
}  // namespace sectile
