// Regions in bends and holes of others: the loops next to a hole lead to the loop around it.
#include "boolean/joining/next_loops.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <random>
#include <set>
#include <vector>

#include "cases.h"

namespace sectile {
namespace {

struct Corner {
  int x, y;
  auto operator<=>(const Corner&) const = default;
};
using Loop = std::vector<Corner>;

// Squares of a lattice, of which those of one colour that hang together are a region.
class Picture {
 public:
  static constexpr int size = 24;

  int& colour(int x, int y) { return colour_[index(x, y)]; }

  void find_regions() {
    region_.fill(-1);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x)
        if (region_[index(x, y)] < 0) spread(x, y, regions_++);
  }
  int regions() const { return regions_; }

  /// With the region on their left. Where squares touch in a corner, loops go on from one to the
  /// other, or stay with each.
  std::vector<Loop> loops(int region, bool go_on) const {
    std::set<std::pair<Corner, Corner>> edges;
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        if (at(x, y) != region) continue;
        if (at(x, y - 1) != region) edges.insert({{x, y}, {x + 1, y}});
        if (at(x + 1, y) != region) edges.insert({{x + 1, y}, {x + 1, y + 1}});
        if (at(x, y + 1) != region) edges.insert({{x + 1, y + 1}, {x, y + 1}});
        if (at(x - 1, y) != region) edges.insert({{x, y + 1}, {x, y}});
      }
    std::vector<Loop> all;
    while (!edges.empty()) all.push_back(take_loop(edges, go_on));
    return all;
  }

 private:
  static std::size_t index(int x, int y) { return static_cast<std::size_t>(y * size + x); }
  int at(int x, int y) const {
    return x < 0 || y < 0 || x >= size || y >= size ? -1 : region_[index(x, y)];
  }

  void spread(int x, int y, int region) {
    std::vector<Corner> open{{x, y}};
    while (!open.empty()) {
      const Corner c = open.back();
      open.pop_back();
      if (c.x < 0 || c.y < 0 || c.x >= size || c.y >= size) continue;
      if (region_[index(c.x, c.y)] >= 0 || colour(c.x, c.y) != colour(x, y)) continue;
      region_[index(c.x, c.y)] = region;
      for (const auto& [dx, dy] : {Corner{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
        open.push_back({c.x + dx, c.y + dy});
    }
  }

  static Loop take_loop(std::set<std::pair<Corner, Corner>>& edges, bool go_on) {
    const int first = go_on ? -1 : 1;  // to the left
    auto edge = *edges.begin();
    Loop loop;
    while (edges.erase(edge) > 0) {
      const auto [from, to] = edge;
      loop.push_back(from);
      const int x = to.x - from.x, y = to.y - from.y;
      for (const auto& [dx, dy] : {Corner{-y * first, x * first}, {x, y}, {y * first, -x * first}})
        if (edge = {to, {to.x + dx, to.y + dy}}; edges.contains(edge)) break;
    }
    return loop;
  }

  std::array<int, size * size> colour_{}, region_{};
  int regions_ = 0;
};

int two_areas(const Loop& loop) {
  int sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Corner &p = loop[i], &q = loop[(i + 1) % loop.size()];
    sum += p.x * q.y - p.y * q.x;
  }
  return sum;
}

// All loops of a picture, holes first, in a plane that is seen along any axis from either side.
struct Scene {
  std::vector<Loop> loops;
  std::vector<int> region;  // per loop
  std::uint32_t holes = 0;
  Geometry geometry;
  PlaneId plane;
  std::vector<PointId> corners;
  std::vector<std::uint32_t> ends;

  explicit Scene(const Picture& picture, std::mt19937& random) {
    const bool go_on = random() % 2 == 0;
    for (const bool hole : {true, false}) {
      for (int r = 0; r < picture.regions(); ++r)
        for (const Loop& loop : picture.loops(r, go_on))
          if ((two_areas(loop) < 0) == hole) add(loop, r);
      if (hole) holes = static_cast<std::uint32_t>(loops.size());
    }
    const int axis = static_cast<int>(random() % 3);
    const bool from_below = random() % 2 == 0;
    const int slant = static_cast<int>(random() % 5) - 2;
    std::map<Corner, PointId> points;
    const auto point = [&](const Corner& c) {
      if (const auto at = points.find(c); at != points.end()) return at->second;
      // Turned and stretched, which leaves all that lies in each other as it was.
      const double i = 5 * c.x + slant * c.y, j = 3 * c.y - slant * c.x;
      double x[3];
      x[(axis + 1) % 3] = from_below ? j : i;
      x[(axis + 2) % 3] = from_below ? i : j;
      x[axis] = 0.25 * i - 0.5 * j;
      return points[c] = geometry.add_point({x[0], x[1], x[2]});
    };
    for (const Loop& loop : loops) {
      for (const Corner& c : loop) corners.push_back(point(c));
      ends.push_back(static_cast<std::uint32_t>(corners.size()));
    }
    plane =
        geometry.add_plane(PlaneDefinition::through(point({0, 0}), point({1, 0}), point({0, 1})));
  }

  void add(const Loop& loop, int of) {
    loops.push_back(loop);
    region.push_back(of);
  }
};

// Frames and slabs on each other.
Picture random_picture(std::mt19937& random) {
  const auto below = [&](int n) { return static_cast<int>(random() % unsigned(n)); };
  Picture picture;
  const bool few_colours = below(2) == 0;
  for (int n = 4 + below(30); n > 0; --n) {
    const int colour = few_colours ? below(3) : n;
    const int left = below(Picture::size), low = below(Picture::size),
              right = std::min(left + 1 + below(16), Picture::size),
              high = std::min(low + 1 + below(16), Picture::size);
    const bool frame = below(3) > 0;
    for (int y = low; y < high; ++y)
      for (int x = left; x < right; ++x)
        if (!frame || x == left || y == low || x + 1 == right || y + 1 == high)
          picture.colour(x, y) = colour;
  }
  picture.find_regions();
  return picture;
}

TEST(NextLoops, OfHolesBoundTheSameRegion) {
  std::mt19937 random(1);
  std::size_t known = 0, all = 0;
  for (int n = 0; n < cases(300); ++n) {
    const Scene scene(random_picture(random), random);
    const Kernel kernel(scene.geometry);
    const NextLoops next(kernel, scene.plane, scene.corners, scene.ends, scene.holes);
    for (std::uint32_t hole = 0; hole < scene.holes; ++hole) {
      ++all;
      if (next[hole] == NextLoops::none) continue;
      ++known;
      EXPECT_NE(next[hole], hole);
      EXPECT_EQ(scene.region[next[hole]], scene.region[hole]) << n;
      std::uint32_t at = hole, steps = 0;
      while (at < scene.holes && steps++ < scene.holes) at = next[at];
      EXPECT_GE(at, scene.holes) << "in circles";
    }
  }
  EXPECT_GT(all, std::size_t(cases(500)));
  EXPECT_GT(2 * known, all);
}

// A frame in a frame, and so on, each with a slit: all white is one region, as is all black.
TEST(NextLoops, OfAFrameInTheBendsOfOthers) {
  Picture picture;
  for (int k = 0; k < 5; ++k)
    for (int i = 2 * k; i < Picture::size - 2 * k; ++i)
      for (const int end : {2 * k, Picture::size - 1 - 2 * k}) {
        picture.colour(i, end) = 1;
        if (i != 12 || end < 12) picture.colour(end, i) = 1;
      }
  picture.colour(11, 11) = 2;
  picture.find_regions();
  std::mt19937 random(2);
  for (int n = 0; n < 30; ++n) {
    const Scene scene(picture, random);
    const Kernel kernel(scene.geometry);
    const NextLoops next(kernel, scene.plane, scene.corners, scene.ends, scene.holes);
    ASSERT_GT(scene.holes, 0u);
    for (std::uint32_t hole = 0; hole < scene.holes; ++hole) {
      ASSERT_NE(next[hole], NextLoops::none);
      EXPECT_EQ(scene.region[next[hole]], scene.region[hole]);
    }
  }
}

// Squares to the right of one and above it, and two holes with their ends on its sides: a step
// farther is another region.
TEST(NextLoops, OfAHoleThatTouchesASideAreNotThoseBeyond) {
  Geometry geometry;
  std::vector<PointId> corners;
  std::vector<std::uint32_t> ends;
  const auto add = [&](const Loop& loop) {
    for (const Corner& c : loop)
      corners.push_back(geometry.add_point({double(c.x), double(c.y), 0}));
    ends.push_back(static_cast<std::uint32_t>(corners.size()));
  };
  add({{10, 3}, {9, 2}, {8, 3}, {9, 4}});
  add({{4, 10}, {3, 8}, {2, 8}});
  add({{6, 5}, {5, 5}, {5, 6}});
  add({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  add({{10, 0}, {20, 0}, {20, 10}, {10, 10}});
  add({{0, 10}, {20, 10}, {20, 20}, {0, 20}});
  const PlaneId plane =  // a hole turns right
      geometry.add_plane(PlaneDefinition::through(corners[2], corners[1], corners[0]));
  const Kernel kernel(geometry);
  ASSERT_EQ(kernel.normal(plane, 2), Sign::positive);
  const NextLoops next(kernel, plane, corners, ends, 3);
  EXPECT_EQ(next[0], NextLoops::none);
  EXPECT_EQ(next[1], NextLoops::none);
  EXPECT_EQ(next[2], 3u);
}

}  // namespace
}  // namespace sectile
