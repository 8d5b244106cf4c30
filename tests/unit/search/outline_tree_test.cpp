// The tree over a face's edges finds what looking at all of them finds, and looks at few.
#include "search/outline_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "cases.h"
#include "search/piece_tree.h"

namespace sectile {
namespace {

struct Lattice {
  std::int64_t i, j;
};

// Closed loops on a lattice, as seen along an axis; they may do anything.
struct Loops {
  std::vector<Lattice> corners;
  std::vector<std::uint32_t> ends, next;

  void add(const std::vector<Lattice>& loop) {
    const auto first = static_cast<std::uint32_t>(corners.size());
    for (const Lattice& p : loop) {
      corners.push_back(p);
      next.push_back(static_cast<std::uint32_t>(corners.size()));
    }
    next.back() = first;
    ends.push_back(static_cast<std::uint32_t>(corners.size()));
  }
};

std::int64_t turn(const Lattice& a, const Lattice& b, const Lattice& c) {
  return (b.i - a.i) * (c.j - a.j) - (b.j - a.j) * (c.i - a.i);
}

bool is_on(const Lattice& p, const Lattice& a, const Lattice& b) {
  return turn(a, b, p) == 0 && std::min(a.i, b.i) <= p.i && p.i <= std::max(a.i, b.i) &&
         std::min(a.j, b.j) <= p.j && p.j <= std::max(a.j, b.j);
}

// Half-open, as PlanarRay has it.
bool crosses_ray(const Lattice& p, const Lattice& a, const Lattice& b) {
  if ((a.j < p.j) == (b.j < p.j)) return false;
  return (turn(a, b, p) > 0) == (a.j < b.j);
}

// Of two edges that cross the line of the ray: is the first one crossed before the other?
bool is_before(const Lattice& p, const Lattice& a, const Lattice& b, const Lattice& c,
               const Lattice& d) {
  // i = a.i + (b.i - a.i) · (p.j - a.j) / (b.j - a.j).
  const std::int64_t below = std::abs(b.j - a.j), below_other = std::abs(d.j - c.j);
  const std::int64_t above = a.i * below + (b.i - a.i) * (p.j - a.j) * (b.j > a.j ? 1 : -1),
                     above_other =
                         c.i * below_other + (d.i - c.i) * (p.j - c.j) * (d.j > c.j ? 1 : -1);
  return above * below_other < above_other * below;
}

struct Scene {
  Loops loops;
  OutlineTree tree;
  int axis;
  double scale;

  Scene(Loops some, int seen_along, double times)
      : loops(std::move(some)),
        tree(places(loops, seen_along, times), loops.ends, seen_along),
        axis(seen_along),
        scale(times) {}

  static Vec3 place(const Lattice& p, int axis, double scale) {
    double x[3] = {0, 0, 0};
    x[(axis + 1) % 3] = static_cast<double>(p.i) * scale;
    x[(axis + 2) % 3] = static_cast<double>(p.j) * scale;
    return {x[0], x[1], x[2]};
  }
  static std::vector<Vec3> places(const Loops& loops, int axis, double scale) {
    std::vector<Vec3> all;
    for (const Lattice& p : loops.corners) all.push_back(place(p, axis, scale));
    return all;
  }

  struct Count {
    bool odd = false, touches = false;
    std::size_t looks = 0;
  };
  Count by_tree(const Lattice& p) const {
    Count count;
    const auto look = [&](std::uint32_t e) {
      const Lattice &a = loops.corners[e], &b = loops.corners[loops.next[e]];
      ++count.looks;
      if (is_on(p, a, b)) count.touches = true;
      if (crosses_ray(p, a, b)) count.odd = !count.odd;
    };
    const auto pass = [&](std::uint32_t from, std::uint32_t to) {
      if ((loops.corners[from].j < p.j) != (loops.corners[to].j < p.j)) count.odd = !count.odd;
    };
    const double i = static_cast<double>(p.i) * scale, j = static_cast<double>(p.j) * scale;
    tree.cast_ray({{i, j}, {i, j}}, look, pass);
    return count;
  }
  // Of a nested outline: the edge that is crossed first, if the tree knows; and what it looked at.
  std::optional<std::uint32_t> first(const Lattice& p, std::set<std::uint32_t>& looked) const {
    const double i = static_cast<double>(p.i) * scale, j = static_cast<double>(p.j) * scale;
    return tree.first_on_ray({{i, j}, {i, j}}, [&](std::uint32_t e) {
      EXPECT_TRUE(looked.insert(e).second);
      return crosses_ray(p, loops.corners[e], loops.corners[loops.next[e]]);
    });
  }
  Count by_all(const Lattice& p) const {
    Count count;
    for (std::size_t e = 0; e < loops.corners.size(); ++e) {
      const Lattice &a = loops.corners[e], &b = loops.corners[loops.next[e]];
      if (is_on(p, a, b)) count.touches = true;
      if (crosses_ray(p, a, b)) count.odd = !count.odd;
    }
    return count;
  }
};

Loops slanted_comb(std::int64_t teeth) {
  std::vector<Lattice> loop{{-4, -4}, {8 * teeth + 4, -4}};
  for (std::int64_t t = teeth; t-- > 0;)
    for (const Lattice& p :
         {Lattice{8 * t + 6, 0}, {8 * (t + teeth) + 4, 8 * teeth}, {8 * t + 2, 0}})
      loop.push_back(p);
  Loops loops;
  loops.add(loop);
  return loops;
}

Loops upright_comb(std::int64_t teeth) {
  std::vector<Lattice> loop{{-4, -4}, {8 * teeth + 4, -4}};
  for (std::int64_t t = teeth; t-- > 0;)
    for (const Lattice& p :
         {Lattice{8 * t + 6, 0}, {8 * t + 6, 8 * teeth}, {8 * t + 2, 8 * teeth}, {8 * t + 2, 0}})
      loop.push_back(p);
  Loops loops;
  loops.add(loop);
  return loops;
}

// Slanted squares in squares: their boxes overlap, and a ray from within crosses all around it.
Loops rings(std::int64_t count) {
  Loops loops;
  for (std::int64_t r = 10; r <= 10 * count; r += 10)
    loops.add({{3 * r, r}, {-r, 3 * r}, {-3 * r, -r}, {r, -3 * r}});
  return loops;
}

class Random {
 public:
  explicit Random(unsigned seed) : random_(seed) {}
  std::int64_t below(std::int64_t n) {
    return static_cast<std::int64_t>(random_() % static_cast<std::uint64_t>(n));
  }
  // Short steps or long ones, in few directions or in any; or to and fro between two places.
  Loops loops(std::int64_t size) {
    Loops all;
    if (below(2) == 0) {
      std::vector<Lattice> loop;
      const Lattice by{4 * below(size) - 2 * size, 3 * size};
      for (std::int64_t c = 20 + below(80); c > 0; --c)
        for (const std::int64_t end : {0, 1})
          loop.push_back({end * by.i + below(size), end * by.j + below(5)});
      all.add(loop);
      return all;
    }
    for (std::int64_t l = 1 + below(8); l > 0; --l) {
      std::vector<Lattice> loop;
      const bool along = below(2) == 0;
      const Lattice by{1 + below(size), below(size)};
      Lattice at{below(size), below(size)};
      for (std::int64_t c = 3 + below(40); c > 0; --c) {
        loop.push_back(at);
        const std::int64_t far = along ? below(7) - 3 : 0;
        at = {at.i + far * by.i + below(5) - 2, at.j + far * by.j + below(5) - 2};
      }
      all.add(loop);
    }
    return all;
  }

 private:
  std::mt19937_64 random_;
};

TEST(OutlineTree, SaysWhatAllEdgesSay) {
  Random random(1);
  for (int n = 0; n < 3000; ++n) {
    const double scales[] = {1, 0x1p-1070, 0x1p1000, 1.5};
    const std::int64_t size = random.below(2) == 0 ? 6 : 60;
    const Scene scene(random.loops(size), n % 3, scales[n % 4]);
    for (int k = 0; k < 60; ++k) {
      const Lattice p =
          k % 3 == 0
              ? scene.loops.corners[static_cast<std::size_t>(
                    random.below(static_cast<std::int64_t>(scene.loops.corners.size())))]
              : Lattice{random.below(5 * size) - 2 * size, random.below(4 * size) - size / 2};
      const Scene::Count one = scene.by_tree(p), other = scene.by_all(p);
      ASSERT_EQ(one.touches, other.touches) << n << ' ' << p.i << ' ' << p.j;
      ASSERT_EQ(one.odd, other.odd) << n << ' ' << p.i << ' ' << p.j;
    }
  }
}

TEST(OutlineTree, FindsWhatARayCrossesFirst) {
  Random random(6);
  int nested = 0, decided = 0, clear = 0;
  for (int n = 0; n < 3000; ++n) {
    const double scales[] = {1, 0x1p-1070, 0x1p1000, 1.5};
    const std::int64_t size = random.below(2) == 0 ? 6 : 60;
    const Scene scene(random.loops(size), n % 3, scales[n % 4]);
    if (!scene.tree.is_nested()) continue;
    ++nested;
    const Loops& loops = scene.loops;
    for (int k = 0; k < 60; ++k) {
      const Lattice p =
          k % 3 == 0
              ? loops.corners[static_cast<std::size_t>(
                    random.below(static_cast<std::int64_t>(loops.corners.size())))]
              : Lattice{random.below(5 * size) - 2 * size, random.below(4 * size) - size / 2};
      std::set<std::uint32_t> looked;
      const auto first = scene.first(p, looked);
      for (std::uint32_t e = 0; e < loops.corners.size(); ++e) {
        const Lattice &a = loops.corners[e], &b = loops.corners[loops.next[e]];
        if (is_on(p, a, b)) {
          ASSERT_TRUE(looked.contains(e)) << n << ' ' << k;
        }
        if (!first || *first == e || !crosses_ray(p, a, b)) continue;
        ASSERT_NE(*first, StripTree::no_edge) << n << ' ' << k;
        ASSERT_TRUE(is_before(p, loops.corners[*first], loops.corners[loops.next[*first]], a, b))
            << n << ' ' << k;
      }
      decided += first ? 1 : 0;
      clear += first == StripTree::no_edge ? 1 : 0;
    }
  }
  EXPECT_GT(nested, 200);
  EXPECT_GT(decided, 30 * nested);
  EXPECT_GT(clear, nested);
}

TEST(OutlineTree, LooksAtFewEdgesOfAComb) {
  for (const bool upright : {false, true}) {
    const Scene scene(upright ? upright_comb(1000) : slanted_comb(1000), 2, 1);
    Random random(2);
    std::size_t looks = 0;
    for (int k = 0; k < 200; ++k) {
      const Lattice p{random.below(16'000), random.below(8'000)};
      const Scene::Count one = scene.by_tree(p), other = scene.by_all(p);
      EXPECT_EQ(one.odd, other.odd);
      looks += one.looks;
    }
    EXPECT_LT(looks, 200 * 40u) << (upright ? "upright" : "slanted");
  }
}

TEST(OutlineTree, LooksAtFewEdgesOfRingsInRings) {
  const Scene scene(rings(500), 2, 1);
  Random random(5);
  std::size_t looks = 0;
  for (int k = 0; k < 200; ++k) {
    const Lattice p{random.below(20'000) - 10'000, random.below(20'000) - 10'000};
    const Scene::Count one = scene.by_tree(p), other = scene.by_all(p);
    EXPECT_EQ(one.odd, other.odd);
    looks += one.looks;
  }
  EXPECT_LT(looks, 200 * 4u);
}

TEST(OutlineTree, LooksAtFewRingsUntilTheFirstOne) {
  const Scene scene(rings(500), 2, 1);
  ASSERT_TRUE(scene.tree.is_nested());
  Random random(7);
  std::set<std::uint32_t> looked;
  std::size_t looks = 0;
  for (int k = 0; k < 200; ++k) {
    const Lattice p{random.below(10'000) - 5'000, random.below(10'000) - 5'000};
    looked.clear();
    EXPECT_TRUE(scene.first(p, looked));
    looks += looked.size();
  }
  EXPECT_LT(looks, 200 * 20u);
}

// Boxes of many overlap that of a thin triangle, which lies between two of them.
TEST(OutlineTree, FindsFewEdgesBesideATriangleBetweenRings) {
  const Scene scene(rings(500), 2, 1);
  const Vec3 between[] = {{7509, 2510, 0}, {7505, 2505, 0}, {-2480, 7497, 0}};
  std::size_t found = 0;
  scene.tree.query(OutlineTree::Target(between), [&](std::uint32_t) { ++found; });
  EXPECT_LT(found, 8u);
}

TEST(OutlineTree, FindsAllEdgesThatMeetATriangle) {
  Random random(3);
  for (int n = 0; n < 2000; ++n) {
    const int axis = n % 3;
    const std::int64_t size = 20;
    const Scene scene(random.loops(size), axis, 1);
    Lattice t[3];
    const Lattice at{random.below(4 * size) - 2 * size, random.below(3 * size)};
    const std::int64_t reach = n % 2 == 0 ? size : 4;
    for (Lattice& p : t) p = {at.i + random.below(reach), at.j + random.below(reach)};
    if (turn(t[0], t[1], t[2]) == 0) continue;
    if (turn(t[0], t[1], t[2]) < 0) std::swap(t[1], t[2]);
    std::set<std::uint32_t> found;
    const Vec3 corners[] = {Scene::place(t[0], axis, 1), Scene::place(t[1], axis, 1),
                            Scene::place(t[2], axis, 1)};
    scene.tree.query(OutlineTree::Target(corners), [&](std::uint32_t e) { found.insert(e); });
    const auto holds = [&](const Lattice& p) {
      return turn(t[0], t[1], p) >= 0 && turn(t[1], t[2], p) >= 0 && turn(t[2], t[0], p) >= 0;
    };
    for (std::uint32_t e = 0; e < scene.loops.corners.size(); ++e) {
      const Lattice &a = scene.loops.corners[e], &b = scene.loops.corners[scene.loops.next[e]];
      bool meets = holds(a) || holds(b);
      for (int k = 0; k < 3; ++k) {
        const Lattice &u = t[k], &v = t[(k + 1) % 3];
        const auto sign = [](std::int64_t x) { return x > 0 ? 1 : x < 0 ? -1 : 0; };
        meets = meets || (sign(turn(a, b, u)) * sign(turn(a, b, v)) < 0 &&
                          sign(turn(u, v, a)) * sign(turn(u, v, b)) < 0);
      }
      if (meets) {
        ASSERT_TRUE(found.contains(e)) << n << ' ' << e;
      }
    }
  }
}

TEST(OutlineTree, FindsFewTeethThatComeNearToOne) {
  const Scene scene(slanted_comb(1000), 2, 1);
  const Vec3 wall[] = {{4003, 0, -1}, {12003, 8000, -1}, {12003, 8000, 1}, {4003, 0, 1}};
  std::size_t found = 0;
  scene.tree.query(OutlineTree::Target(wall), [&](std::uint32_t) { ++found; });
  EXPECT_LT(found, 40u);
}

// Long edges through lattice points, so that all through one point meet.
TEST(PieceTree, FindsAllPairsOfEdgesThatMeet) {
  Random random(4);
  for (int n = 0; n < cases(300); ++n) {
    std::vector<PieceTree::Edge> edges;
    std::vector<std::int64_t> centre;
    const bool parallel = n % 2 == 0;
    for (int k = 0; k < 120; ++k) {
      const std::int64_t c = random.below(12);
      const auto x = static_cast<double>(c), y = static_cast<double>(c * c % 7), z = 3.0 * x;
      const auto u = static_cast<double>(random.below(400)),
                 v = static_cast<double>(parallel ? 1 : random.below(9)), w = random.below(2) + u;
      edges.push_back({{x - u, y - v, z - w}, {x + u, y + v, z + w}});
      centre.push_back(c);
    }
    const PieceTree tree(edges);
    std::set<std::pair<std::uint32_t, std::uint32_t>> self, both;
    tree.self_overlaps([&](std::uint32_t i, std::uint32_t j) {
      EXPECT_TRUE(self.insert(std::minmax(i, j)).second);
    });
    PieceTree::overlaps(tree, PieceTree(edges, true), [&](std::uint32_t i, std::uint32_t j) {
      EXPECT_TRUE(both.insert({i, j}).second);
    });
    for (std::uint32_t i = 0; i < edges.size(); ++i)
      for (std::uint32_t j = 0; j < edges.size(); ++j)
        if (centre[i] == centre[j]) {
          ASSERT_TRUE(both.contains({i, j}));
          if (i < j) {
            ASSERT_TRUE(self.contains({i, j}));
          }
        }
  }
}

TEST(PieceTree, KnowsThatSlantedEdgesSideBySideAreApart) {
  std::vector<PieceTree::Edge> edges;
  for (int i = 0; i < 2000; ++i) {
    const double x = i;
    edges.push_back({{x, 0, 0}, {x + 2000, 2000, 700}});
  }
  std::size_t found = 0;
  PieceTree(edges).self_overlaps([&](std::uint32_t, std::uint32_t) { ++found; });
  EXPECT_LT(found, 2000 * 40u);  // of 2,000,000 pairs of boxes that overlap
}

}  // namespace
}  // namespace sectile
