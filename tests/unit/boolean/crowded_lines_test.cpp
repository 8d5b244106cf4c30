// Two books of which no two pages are of one length: what is tested, and what is not.
#include "boolean/near/crowded_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "boolean/boolean.h"
#include "boolean/loading/load.h"
#include "boolean/reduction/clusters.h"
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
    const Clusters all(w, pairs);
    contacts = reduce(w, pairs);
    if (leaves_out())
      for (const Contact& c : contacts.contacts) clusters.insert(all.of(c));
  }
  bool leaves_out() const { return !w.patch[Operand::a].on_crowded_line.empty(); }

  BooleanOptions options;
  Workspace w;
  FacePairs pairs;
  std::set<std::uint32_t> clusters;  // in which anything meets
  Contacts contacts;
};

const Operation unite[] = {Operation::unite};

TEST(CrowdedLines, PagesThatOverlapAreAClusterEach) {
  const Reduced found(book(0, 0.5, 0), book(0.25, 0.5, 0.5), {unite});
  EXPECT_TRUE(found.leaves_out());
  EXPECT_EQ(found.clusters.size(), unsigned(pages));
  // Walls, ends of them, and each page's own edge along the line.
  EXPECT_LT(found.pairs.size(), 30u * pages);
  EXPECT_LT(found.contacts.segments.size(), 30u * pages);
}

TEST(CrowdedLines, PagesBesideEachOtherMeetInNothing) {
  const Reduced found(book(0, 0.3, 0), book(0.5, 0.3, 0.5), {unite});
  EXPECT_TRUE(found.leaves_out());
  EXPECT_EQ(found.contacts.segments.size(), 0u);
}

// What is beside the line in one direction only says nothing of the others.
TEST(CrowdedLines, PagesAllAroundAreOneCluster) {
  const Reduced found(book(0, 0.7, 0), book(0.5, 0.7, 0.5), {unite});
  EXPECT_TRUE(found.leaves_out());
  EXPECT_EQ(found.clusters.size(), 1u);
}

// No end of a page divides them yet.
TEST(CrowdedLines, EdgesOfBothAlongTheLineAreARow) {
  const Reduced found(book(0, 0.7, 0), book(0.5, 0.7, 0.5), {unite});
  EXPECT_FALSE(found.contacts.has_unswept_lines);
  ASSERT_EQ(found.contacts.rows.size(), 1u);
  const Row& row = found.contacts.rows[0];
  EXPECT_EQ(row.runs.size(), 2u * pages);
  EXPECT_EQ(row.places.size(), 4u * pages);
  EXPECT_LT(found.contacts.segments.size(), 30u * pages);
  for (const SegmentRecord& r : found.contacts.segments)
    EXPECT_FALSE(r.on[Operand::a].is_edge() && r.on[Operand::b].is_edge());
}

// A page that goes on beyond the line: pages of the other book have edges in its face.
TEST(CrowdedLines, HaveNoRowWhereEdgesAreInAFace) {
  const Solid across = transformed(block({-1, -1e-3, 0.5}, {1, 0, 1.25}),
                                   Transform::rotation_degrees({0, 0, 1}, 1.2 * 360 / pages));
  const Solid b = boolean(book(0.5, 0.3, 0.5), across, Operation::unite);
  const Reduced found(book(0, 0.3, 0), b, {unite});
  ASSERT_TRUE(found.leaves_out());
  EXPECT_TRUE(found.contacts.has_unswept_lines);
  EXPECT_TRUE(found.contacts.rows.empty());
}

// Two quarters, one above the other in part, have a common face, in which the line runs as far as
// both reach, and corners on the line. The other solid meets it, but not there.
TEST(CrowdedLines, HaveNoRowWhereAFaceLiesOnBothSides) {
  const Solid quarters =
      boolean(block({0, 0, 5}, {1, 1, 10}), block({-1, 0, 7}, {0, 1, 15}), Operation::unite);
  const Solid joined = Solid::from_mesh(quarters.to_mesh());  // with flat faces joined
  const Solid b = boolean(book(0.5, 0.3, 0.5), joined, Operation::unite);
  const Solid stick =
      boolean(book(0, 0.3, 0), block({0.5, -0.5, 8}, {0.6, 0.5, 9}), Operation::unite);
  const Reduced found(stick, b, {unite});
  ASSERT_TRUE(found.leaves_out());
  EXPECT_TRUE(found.contacts.has_unswept_lines);
  EXPECT_TRUE(found.contacts.rows.empty());
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
  EXPECT_FALSE(Reduced(a, b, {}).leaves_out());
  EXPECT_FALSE(Reduced(a, b, {unite}, observed).leaves_out());
}

TEST(CrowdedLines, RaysBeginBesideTheLine) {
  const Solid a = book(0, 0.3, 0), b = book(0.5, 0.3, 0.5);
  EXPECT_TRUE(boolean(a, b, Operation::intersect).is_empty());
  EXPECT_TRUE(boolean(a, b, Operation::subtract) == a);
  EXPECT_NEAR(boolean(a, b, Operation::unite).volume(), a.volume() + b.volume(), 1e-12);
}

}  // namespace
}  // namespace sectile
