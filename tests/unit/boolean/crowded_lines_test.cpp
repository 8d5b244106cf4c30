// Two books of which no two pages are of one length: what is tested, and what is not.
#include "boolean/near/crowded_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <vector>

#include "boolean/boolean.h"
#include "boolean/loading/load.h"
#include "sectile/boolean.h"
#include "sectile/primitives.h"
#include "sectile/trace.h"
#include "sectile/transform.h"

namespace sectile {
namespace {

constexpr int pages = 60;

// Pages between half-planes around the z axis; `part` of the way to the next page is room for one.
Solid book(double first, double part, double low) {
  PolygonMesh mesh;
  for (int i = 0; i < pages; ++i) {
    const auto o = static_cast<std::uint32_t>(mesh.positions.size());
    for (const double z : {low + 0.001 * (7 * i % pages), low + 1 + 0.001 * (11 * i % pages)}) {
      mesh.positions.push_back({0, 0, z});
      for (const double at : {first + i, first + i + part}) {
        const double angle = 2 * std::numbers::pi * at / pages;
        mesh.positions.push_back({std::cos(angle), std::sin(angle), z});
      }
    }
    mesh.face_sizes.insert(mesh.face_sizes.end(), {3, 3, 4, 4, 4});
    for (const std::uint32_t k :
         {0u, 2u, 1u, 3u, 4u, 5u, 0u, 1u, 4u, 3u, 1u, 2u, 5u, 4u, 2u, 0u, 3u, 5u})
      mesh.indices.push_back(o + k);
  }
  return Solid::from_mesh(mesh);
}

struct Reduced {
  Reduced(const Solid& a, const Solid& b, const Wanted& wanted, BooleanOptions o = {})
      : options(std::move(o)), w(options) {
    load(w, *a.data(), *b.data(), pairs, wanted);
    leaves_out_pairs = !w.crowded_lines.empty();
    contacts = reduce(w, pairs);
  }
  double height(std::uint32_t place) const {
    return w.geometry.position(contacts.point(contacts.rows[0].places[place])).z;
  }

  bool is_on_line(PlaceId place) const {
    const Vec3& p = w.geometry.position(contacts.point(place));
    return p.x == 0 && p.y == 0;
  }

  BooleanOptions options;
  Workspace w;
  FacePairs pairs;
  bool leaves_out_pairs;
  Contacts contacts;
};

const Operation unite[] = {Operation::unite};

TEST(CrowdedLines, PagesThatLeaveThemInDifferentDirectionsAreInNoPair) {
  const Reduced apart(book(0, 0.3, 0), book(0.5, 0.3, 0.5), {unite});
  EXPECT_TRUE(apart.leaves_out_pairs);
  EXPECT_EQ(apart.contacts.segments.size(), 0u);
  // Walls, and ends of them.
  const Reduced overlap(book(0, 0.5, 0), book(0.25, 0.5, 0.5), {unite});
  EXPECT_TRUE(overlap.leaves_out_pairs);
  EXPECT_LT(overlap.pairs.size(), 20u * pages);
}

// No end of a page divides them yet.
TEST(CrowdedLines, EdgesOfBothAlongTheLineAreARow) {
  const Reduced found(book(0, 0.7, 0), book(0.5, 0.7, 0.5), {unite});
  ASSERT_EQ(found.contacts.rows.size(), 1u);
  const Row& row = found.contacts.rows[0];
  EXPECT_EQ(row.runs.size(), 2u * pages);
  EXPECT_EQ(row.places.size(), 4u * pages);
  EXPECT_LT(found.contacts.segments.size(), 30u * pages);
  for (const SegmentRecord& r : found.contacts.segments)
    EXPECT_FALSE(r.on[Operand::a].is_edge() && r.on[Operand::b].is_edge());
}

// Runs of a row that are stretches in faces.
std::vector<Row::Run> faces_of(const Row& row) {
  std::vector<Row::Run> faces;
  std::ranges::copy_if(row.runs, std::back_inserter(faces),
                       [](const Row::Run& run) { return run.carrier.is_face(); });
  return faces;
}

// A floor that the line runs in, from edge to edge: pages of the other book have edges in it.
TEST(CrowdedLines, AFaceOnBothSidesIsInTheRow) {
  const Solid across = transformed(block({-1, -1e-3, 0.25}, {1, 0, 1.75}),
                                   Transform::rotation_degrees({0, 0, 1}, 1.2 * 360 / pages));
  const Solid b = boolean(book(0.5, 0.3, 0.5), across, Operation::unite);
  const Reduced found(book(0, 0.3, 0), b, {unite});
  ASSERT_TRUE(found.leaves_out_pairs);
  ASSERT_EQ(found.contacts.rows.size(), 1u);
  const std::vector<Row::Run> faces = faces_of(found.contacts.rows[0]);
  ASSERT_EQ(faces.size(), 1u);
  EXPECT_EQ(faces[0].operand, Operand::b);
  EXPECT_TRUE(faces[0].end[0].is_edge());
  EXPECT_TRUE(faces[0].end[1].is_edge());
  EXPECT_EQ(found.height(faces[0].from), 0.25);
  EXPECT_EQ(found.height(faces[0].to), 1.75);
}

// Two quarters, one above the other in part, have a common face, in which the line runs as far as
// both reach, and corners on the line. The other solid meets it, but not there.
TEST(CrowdedLines, AFaceWithCornersOnTheLineIsInTheRow) {
  const Solid quarters =
      boolean(block({0, 0, 5}, {1, 1, 10}), block({-1, 0, 7}, {0, 1, 15}), Operation::unite);
  const Solid joined = Solid::from_mesh(quarters.to_mesh());  // with flat faces joined
  const Solid b = boolean(book(0.5, 0.3, 0.5), joined, Operation::unite);
  const Solid stick =
      boolean(book(0, 0.3, 0), block({0.5, -0.5, 8}, {0.6, 0.5, 9}), Operation::unite);
  const Reduced found(stick, b, {unite});
  ASSERT_TRUE(found.leaves_out_pairs);
  ASSERT_EQ(found.contacts.rows.size(), 1u);
  const std::vector<Row::Run> faces = faces_of(found.contacts.rows[0]);
  ASSERT_EQ(faces.size(), 1u);
  EXPECT_TRUE(faces[0].end[0].is_vertex());
  EXPECT_TRUE(faces[0].end[1].is_vertex());
  EXPECT_EQ(found.height(faces[0].from), 7);
  EXPECT_EQ(found.height(faces[0].to), 10);
}

// Of a book that stands on a floor all pairs with it are few, but the ends of the pages would
// divide the edges of all others.
TEST(CrowdedLines, PagesOnAFloorAreARowWithoutPairsLeftOut) {
  const Solid floor = block({-2, -2, -1}, {2, 0, 3});
  const Reduced found(floor, book(0, 0.3, 0), {unite});
  EXPECT_FALSE(found.leaves_out_pairs);
  ASSERT_EQ(found.contacts.rows.size(), 1u);
  EXPECT_EQ(faces_of(found.contacts.rows[0]).size(), 1u);
  EXPECT_EQ(found.contacts.rows[0].runs.size(), 1u + pages);
  for (const SegmentRecord& r : found.contacts.segments)
    EXPECT_FALSE(found.is_on_line(r.place[0]) && found.is_on_line(r.place[1]));
}

// One has no edges of the other solid in it.
TEST(CrowdedLines, FloorsThatCrossInThemAreBothInTheRow) {
  const Solid floor = block({-2, -2, -1}, {2, 0, 3}),
              turned = transformed(floor, Transform::rotation_degrees({0, 0, 1}, 35.4)),
              all = boolean(book(0, 0.3, 0), book(0.5, 0.3, 0), Operation::unite);
  const Reduced found(floor, boolean(turned, all, Operation::unite), {unite});
  ASSERT_EQ(found.contacts.rows.size(), 1u);
  const std::vector<Row::Run> faces = faces_of(found.contacts.rows[0]);
  ASSERT_EQ(faces.size(), 2u);
  EXPECT_NE(faces[0].operand, faces[1].operand);
}

// Pages along two lines in a floor, above it and below it, none of them flush with it.
Solid pages_on_both_sides(double from_of_second) {
  const auto half = [](double low, double from_y) {
    const Solid all = boolean(book(0.1, 0.3, low), book(0.6, 0.3, low), Operation::unite);
    return boolean(all, block({-3, from_y, -3}, {3, from_y + 3, 3}), Operation::intersect);
  };
  const Transform turn = Transform::rotation_degrees({0, 1, 0}, 90);
  return boolean(half(-0.5, 0), transformed(half(from_of_second, -3), turn), Operation::unite);
}

// Is a floor of A met in the origin?
bool is_met_in_origin(const Reduced& found, const Row& row) {
  return std::ranges::any_of(row.meetings, [&](const Row::Meeting& m) {
    const Row::Run& run = row.runs[m.run];
    return run.operand == Operand::a && run.carrier.is_face() &&
           found.w.geometry.position(found.contacts.point(row.places[m.place])) == Vec3();
  });
}

TEST(CrowdedLines, ThatCrossInAFaceAreDividedThere) {
  const Solid floor = block({-3, -3, -3}, {3, 0, 3});
  const Reduced crossing(floor, pages_on_both_sides(-0.5), {unite});
  ASSERT_EQ(crossing.contacts.rows.size(), 2u);
  for (const Row& row : crossing.contacts.rows) EXPECT_TRUE(is_met_in_origin(crossing, row));
  const Reduced beside(floor, pages_on_both_sides(0.5), {unite});
  ASSERT_EQ(beside.contacts.rows.size(), 2u);
  for (const Row& row : beside.contacts.rows) EXPECT_FALSE(is_met_in_origin(beside, row));
}

// Each end of a page is one of a piece of itself, of two neighbours, and of what they are paired
// with.
TEST(CrowdedLines, PagesAllAroundAreDividedAtFewEndsOfOthers) {
  for (const Operation operation : {Operation::unite, Operation::intersect, Operation::subtract}) {
    const Operation wanted[] = {operation};
    Reduced found(book(0, 0.7, 0), book(0.5, 0.7, 0.5), {wanted});
    const std::size_t segments = found.contacts.segments.size();
    const CutBoundaries cut = cut_at(found.w, std::move(found.contacts), {wanted});
    EXPECT_GT(cut.neighborhoods.segments.size(), segments + 2u * pages);
    EXPECT_LT(cut.neighborhoods.segments.size(), segments + 15u * pages);
  }
}

TEST(CrowdedLines, NothingIsLeftOutWhereAllIsAskedFor) {
  struct Listener : Observer {
    void phase_done(Phase, const std::vector<TraceEvent>&) override {}
  } listener;
  BooleanOptions observed;
  observed.observer = &listener;
  const Solid a = book(0, 0.5, 0), b = book(0.25, 0.5, 0.5);
  EXPECT_FALSE(Reduced(a, b, {}).leaves_out_pairs);
  const Reduced shown(a, b, {unite}, observed);
  EXPECT_FALSE(shown.leaves_out_pairs);
  EXPECT_TRUE(shown.contacts.rows.empty());
}

TEST(CrowdedLines, RaysBeginBesideTheLine) {
  const Solid a = book(0, 0.3, 0), b = book(0.5, 0.3, 0.5);
  EXPECT_TRUE(boolean(a, b, Operation::intersect).is_empty());
  EXPECT_TRUE(boolean(a, b, Operation::subtract) == a);
  EXPECT_NEAR(boolean(a, b, Operation::unite).volume(), a.volume() + b.volume(), 1e-12);
}

}  // namespace
}  // namespace sectile
