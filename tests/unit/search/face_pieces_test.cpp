// Faces in pieces: a ring is near what lies on its material, and not what lies in its hole.
#include "search/face_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace sectile {
namespace {

using Loop = std::vector<Vec3>;

Loop square(double size, double z = 0) {
  return {{-size, -size, z}, {size, -size, z}, {size, size, z}, {-size, size, z}};
}
Loop turned(Loop loop) {
  std::reverse(loop.begin(), loop.end());
  return loop;
}

bool is_hollow(const std::vector<Loop>& loops) {
  std::vector<Vec3> corners;
  std::vector<std::uint32_t> ends;
  for (const Loop& loop : loops) {
    corners.insert(corners.end(), loop.begin(), loop.end());
    ends.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  return is_hollow(corners, ends);
}

TEST(FacePieces, AFaceIsHollowIfItLeavesMostOfItsBoxEmpty) {
  EXPECT_FALSE(is_hollow({square(4)}));
  EXPECT_FALSE(is_hollow({square(4), turned(square(2))}));
  EXPECT_TRUE(is_hollow({square(4), turned(square(3))}));
  const Loop hook{{0, 0, 0}, {8, 0, 0}, {8, 1, 0}, {1, 1, 0}, {1, 8, 0}, {0, 8, 0}};
  EXPECT_TRUE(is_hollow({hook}));
}

TEST(FacePieces, ASlantedFaceIsSeenAlongAnAxis) {
  const auto slanted = [](Loop loop) {
    for (Vec3& p : loop) p = {p.x + p.y, p.y, p.x - 2 * p.y};
    return loop;
  };
  const Loop octagon{{2, 0, 0}, {4, 0, 0}, {6, 2, 0}, {6, 4, 0},
                     {4, 6, 0}, {2, 6, 0}, {0, 4, 0}, {0, 2, 0}};
  EXPECT_FALSE(is_hollow({octagon}));
  EXPECT_TRUE(is_hollow({slanted(square(4)), slanted(turned(square(3)))}));
}

// Rings between the squares of sizes 1 and 2, 3 and 4 …, and a square post between two neighbours
// each, all in one plane.
class RingsAndPosts {
 public:
  static constexpr std::uint32_t rings = 40;

  RingsAndPosts() {
    for (std::uint32_t i = 0; i < rings; ++i) {
      const double inner = 2 * i + 1;
      add_ring(i, square(inner + 1), turned(square(inner)));
    }
    for (std::uint32_t i = 0; i < rings; ++i) add_post(rings + i, 2 * i + 2.5);
  }

  FacePieces pieces;

 private:
  void add_ring(std::uint32_t face, const Loop& outer, const Loop& hole) {
    Geometry geometry;
    std::vector<PointId> corners;
    for (const Loop* loop : {&outer, &hole})
      for (const Vec3& p : *loop) corners.push_back(geometry.add_point(p));
    const PlaneId plane =
        geometry.add_plane(PlaneDefinition::through(corners[0], corners[1], corners[2]));
    const Kernel kernel(geometry);
    const std::vector<std::uint32_t> ends{4, 8};
    pieces.add_triangles(face, kernel, plane, corners, ends);
  }
  // Its corner lies in the ring.
  void add_post(std::uint32_t face, double x) {
    const Loop post{{x - 0.75, 0, 0}, {x + 0.25, 0, 0}, {x + 0.25, 0.5, 0}, {x - 0.75, 0.5, 0}};
    pieces.add(face, post);
  }
};

std::set<std::pair<std::uint32_t, std::uint32_t>> pairs_of(const PieceSearch& search) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const auto& part : search.parts(4))
    search.for_each_pair(
        part, 1u << 20, [&](std::uint32_t f, std::uint32_t g) { pairs.insert(std::minmax(f, g)); });
  return pairs;
}

TEST(FacePieces, RingsAreNearWhatTouchesThemOnly) {
  const RingsAndPosts scene;
  std::set<std::pair<std::uint32_t, std::uint32_t>> expected;
  for (std::uint32_t i = 0; i < scene.rings; ++i) expected.insert({i, scene.rings + i});
  EXPECT_EQ(pairs_of(PieceSearch(scene.pieces, {})), expected);
}

TEST(FacePieces, OfOneLabelAreNoPairs) {
  const RingsAndPosts scene;
  const std::vector<std::uint32_t> one(2 * scene.rings, 7);
  EXPECT_TRUE(pairs_of(PieceSearch(scene.pieces, one)).empty());
  std::vector<std::uint32_t> two(2 * scene.rings, 0);
  std::fill(two.begin() + scene.rings, two.end(), 1);
  EXPECT_EQ(pairs_of(PieceSearch(scene.pieces, two)).size(), scene.rings);
}

TEST(FacePieces, WhoLooksLongerThanAllowedIsTold) {
  const RingsAndPosts scene;
  const PieceSearch search(scene.pieces, {});
  const auto part = search.parts(1).front();
  const auto ignore = [](std::uint32_t, std::uint32_t) {};
  const std::size_t looks = search.for_each_pair(part, 1u << 20, ignore);
  EXPECT_EQ(search.for_each_pair(part, looks, ignore), looks);
  EXPECT_GT(search.for_each_pair(part, looks / 2, ignore), looks / 2);
}

}  // namespace
}  // namespace sectile
