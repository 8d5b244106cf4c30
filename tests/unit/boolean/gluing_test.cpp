// What is glued of small solids: counts by hand, and seams.
#include "boolean/gluing/gluing.h"

#include <gtest/gtest.h>

#include "boolean/cleanup/cleanup.h"
#include "topology/links.h"
#include "unit/boolean/phases.h"

namespace sectile {
namespace {

using test::Phases;

struct Counts {
  std::size_t vertices, edges, faces, seams;
  friend bool operator==(const Counts&, const Counts&) = default;
};
std::ostream& operator<<(std::ostream& out, const Counts& c) {
  return out << c.vertices << " vertices, " << c.edges << " edges, " << c.faces << " faces, "
             << c.seams << " seams";
}

Counts counts(const Glued& glued) {
  return {glued.brep.vertex_count(), glued.brep.edge_count(), glued.brep.face_count(),
          glued.seams.size()};
}

Glued glued(Phases& phases) {
  Glued result = phases.glued();
  if (result.brep.face_count() > 0) {
    EXPECT_EQ(broken_links(result.brep, false), std::vector<std::string>{});
  }
  EXPECT_TRUE(result.outside.empty());  // solids of one block are made anew
  return result;
}

Glued glued(const Solid& a, const Solid& b, Operation operation) {
  Phases phases(a, b, operation);
  return glued(phases);
}

TEST(Gluing, CubesThatOverlapInACorner) {
  const Solid a = test::lower_cube(), b = test::upper_cube();
  EXPECT_EQ(counts(glued(a, b, Operation::intersect)), (Counts{8, 12, 6, 6}));
  EXPECT_EQ(counts(glued(a, b, Operation::subtract)), (Counts{14, 21, 9, 6}));
  EXPECT_EQ(counts(glued(a, b, Operation::unite)), (Counts{20, 30, 12, 6}));
}

TEST(Gluing, FlushBlocksKeepTheFacesOfBothAndTheirSeamsArePinnedDown) {
  const Glued both = glued(test::lower_cube(), test::flush_block(), Operation::unite);
  EXPECT_EQ(counts(both), (Counts{12, 20, 10, 4}));
  for (const EdgeId e : both.seams) EXPECT_TRUE(both.brep.extra_plane(e).valid());
}

// Four sheets meet in a line: two edges, one for each wedge of material.
TEST(Gluing, BlocksThatTouchInAnEdgeKeepAnEdgeEach) {
  const Glued both = glued(test::lower_cube(), block({2, 2, 0}, {4, 4, 2}), Operation::unite);
  EXPECT_EQ(counts(both), (Counts{16, 24, 12, 0}));
}

TEST(Gluing, AResultHasNoPlanesButThoseOfItsFaces) {
  const auto planes = [](Operation operation) {
    const Solid result = boolean(test::lower_cube(), test::upper_cube(), operation);
    return result.data()->geometry().planes.size();
  };
  EXPECT_EQ(planes(Operation::unite), 12u);
  EXPECT_EQ(planes(Operation::subtract), 9u);
  EXPECT_EQ(planes(Operation::intersect), 6u);
}

TEST(Gluing, NothingThatStaysIsNothing) {
  EXPECT_EQ(counts(glued(test::lower_cube(), test::flush_block(), Operation::intersect)),
            (Counts{0, 0, 0, 0}));
}

TEST(Cleanup, ASeamBetweenPartsOfOneFaceGoesWithItsVertices) {
  const auto [above, below] = split(block({0, 0, 0}, {2, 2, 2}), {0, 0, 1, -1});
  Phases phases(above, below, Operation::unite);
  Glued both = glued(phases);
  EXPECT_EQ(counts(both), (Counts{12, 20, 10, 4}));
  clean_up(both.brep, phases.w.geometry, both.seams);
  EXPECT_EQ(broken_links(both.brep, false), std::vector<std::string>{});
  EXPECT_EQ(both.brep.vertex_count(), 8u);
  EXPECT_EQ(both.brep.edge_count(), 12u);
  EXPECT_EQ(both.brep.face_count(), 6u);
}

TEST(Cleanup, ASeamBetweenFacesOfDifferentSourcesStays) {
  Phases phases(test::lower_cube(), test::flush_block(), Operation::unite);
  Glued both = glued(phases);
  clean_up(both.brep, phases.w.geometry, both.seams);
  EXPECT_EQ(both.brep.face_count(), 10u);
  EXPECT_EQ(both.brep.edge_count(), 20u);
}

}  // namespace
}  // namespace sectile
