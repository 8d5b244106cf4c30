// Each Euler operator keeps the links and Euler and Poincaré's sum, and its inverse restores what
// was there.
#include "topology/euler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "sectile/sectile.h"
#include "storage/solid_data.h"
#include "topology/links.h"

namespace sectile {
namespace {

// The points around a loop, from the one on that gives the least sequence.
std::vector<std::uint32_t> points_of(const Brep& brep, LoopId loop) {
  std::vector<std::uint32_t> points;
  for_each_in_loop(brep, loop,
                   [&](HalfEdgeId h) { points.push_back(brep.point_of(brep.from(h)).value()); });
  std::vector<std::uint32_t> least = points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::rotate(points.begin(), points.begin() + 1, points.end());
    least = std::min(least, points);
  }
  return least;
}

using Shape = std::vector<std::vector<std::vector<std::uint32_t>>>;

// All faces as sets of loops of points, whatever their numbers are.
Shape shape(const Brep& brep) {
  Shape faces;
  for (const FaceId f : brep.faces()) {
    faces.emplace_back();
    for (LoopId l = brep.outer_loop[f]; l.valid(); l = brep.next_loop[l])
      if (brep.loop_half_edge[l].valid()) faces.back().push_back(points_of(brep, l));
    std::sort(faces.back().begin(), faces.back().end());
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

std::int64_t sum(const Brep& brep) {
  const auto n = [](std::size_t count) { return static_cast<std::int64_t>(count); };
  const auto loops = std::count_if(brep.loop_half_edge.begin(), brep.loop_half_edge.end(),
                                   [](HalfEdgeId h) { return h.valid(); });
  return n(brep.vertex_count()) - n(brep.edge_count()) + 2 * n(brep.face_count()) - loops;
}

std::vector<Brep> structures() {
  const Solid cube = block({0, 0, 0}, {4, 4, 4});
  Profile ring;
  ring.outer = {{0, 0}, {6, 0}, {6, 6}, {0, 6}};
  ring.holes = {{{1, 1}, {2, 1}, {2, 2}}, {{3, 3}, {5, 3}, {5, 5}, {3, 5}}};
  const Solid hollow = boolean(cube, block({1, 1, 1}, {2, 2, 2}), Operation::subtract);
  std::vector<Brep> breps;
  for (const Solid& solid : {cube, extrude(ring, 1), hollow, pyramid(2, 2, 5)})
    breps.push_back(solid.data()->brep());
  return breps;
}

constexpr PointId new_point(1000);

// A structure, an operator applied to it, and its inverse.
class Trial {
 public:
  explicit Trial(const Brep& start) : brep(start), shape_(shape(start)), sum_(sum(start)) {}
  Brep brep;
  Euler euler{brep};

  void expect_changed() {
    EXPECT_EQ(broken_links(brep, false), std::vector<std::string>{});
    EXPECT_EQ(sum(brep), sum_);
    EXPECT_NE(shape(brep), shape_);
  }
  void expect_restored() {
    euler.bury();
    EXPECT_EQ(broken_links(brep, false), std::vector<std::string>{});
    EXPECT_EQ(sum(brep), sum_);
    EXPECT_EQ(shape(brep), shape_);
  }

 private:
  Shape shape_;
  std::int64_t sum_;
};

template <class Visit>
void for_each_half_edge(const Visit& visit) {
  for (const Brep& brep : structures())
    for (std::size_t h = 0; h < brep.half_edge_count(); ++h) visit(brep, HalfEdgeId(h));
}

// Pairs of corners in one face.
template <class Visit>
void for_each_pair(const Visit& visit) {
  for_each_half_edge([&](const Brep& brep, HalfEdgeId a) {
    for_each_in_face(brep, brep.face_of(a), [&](HalfEdgeId b) {
      if (a != b) visit(brep, a, b);
    });
  });
}

TEST(Euler, SemvIsUndoneByKev) {
  for_each_half_edge([](const Brep& brep, HalfEdgeId h) {
    for (const bool from_the_other_side : {false, true}) {
      Trial trial(brep);
      const VertexId v = trial.euler.semv(h, new_point);
      EXPECT_EQ(trial.brep.to(h), v);
      trial.expect_changed();
      HalfEdgeId leaving = trial.brep.vertex_half_edge[v];
      if (from_the_other_side) leaving = trial.brep.around(leaving);
      trial.euler.kev(leaving);
      trial.expect_restored();
    }
  });
}

TEST(Euler, MevOfADanglingEdgeIsUndoneByKemr) {
  for_each_half_edge([](const Brep& brep, HalfEdgeId h) {
    for (const unsigned side : {0u, 1u}) {
      Trial trial(brep);
      const HalfEdgeId made = trial.euler.mev(h, h);
      trial.expect_changed();
      EXPECT_FALSE(trial.euler.kemr(Brep::half_edge(Brep::edge_of(made), side)).valid());
      trial.expect_restored();
    }
  });
}

TEST(Euler, MevPartsTheHalfEdgesAroundAVertex) {
  for_each_half_edge([](const Brep& brep, HalfEdgeId first) {
    for (HalfEdgeId end = brep.around(first); end != first; end = brep.around(end)) {
      Trial trial(brep);
      const HalfEdgeId out = trial.euler.mev(first, end);
      trial.expect_changed();
      const VertexId old = trial.brep.from(out), made = trial.brep.to(out);
      EXPECT_EQ(trial.brep.point_of(old), trial.brep.point_of(made));
      bool moves = true;
      HalfEdgeId h = first;
      do {
        if (h == end) moves = false;
        EXPECT_EQ(trial.brep.from(h), moves ? made : old);
        h = brep.around(h);
      } while (h != first);
    }
  });
}

TEST(Euler, MefIsUndoneByKef) {
  for_each_pair([](const Brep& brep, HalfEdgeId a, HalfEdgeId b) {
    if (brep.loop_of(a) != brep.loop_of(b)) return;
    for (const auto which : {Euler::NewFace::shorter, Euler::NewFace::left, Euler::NewFace::right})
      for (const unsigned side : {0u, 1u}) {
        Trial trial(brep);
        const HalfEdgeId h = trial.euler.mef(a, b, which);
        trial.expect_changed();
        EXPECT_EQ(trial.brep.next_of(h), b);
        EXPECT_EQ(trial.brep.next_of(Brep::twin(h)), a);
        if (which == Euler::NewFace::left) {
          EXPECT_EQ(trial.brep.face_of(h), FaceId(brep.face_count()));
        }
        trial.euler.kef(Brep::half_edge(Brep::edge_of(h), side));
        trial.expect_restored();
      }
  });
}

TEST(Euler, MekrIsUndoneByKemr) {
  int pairs = 0;
  for_each_pair([&](const Brep& brep, HalfEdgeId a, HalfEdgeId b) {
    if (brep.loop_of(a) == brep.loop_of(b)) return;
    ++pairs;
    for (const unsigned side : {0u, 1u}) {
      Trial trial(brep);
      const HalfEdgeId h = trial.euler.mekr(a, b);
      trial.expect_changed();
      EXPECT_EQ(trial.brep.loop_of(a), trial.brep.loop_of(b));
      EXPECT_TRUE(trial.euler.kemr(Brep::half_edge(Brep::edge_of(h), side)).valid());
      trial.expect_restored();
    }
  });
  // Corners of a square, a triangle and a square in two faces, in both orders.
  EXPECT_EQ(pairs, 2 * 2 * (4 * 3 + 4 * 4 + 3 * 4));
}

TEST(Euler, MevvrIsUndoneByKemr) {
  for (const Brep& brep : structures())
    for (const FaceId f : brep.faces()) {
      Trial trial(brep);
      const HalfEdgeId h = trial.euler.mevvr(FaceId(f), new_point);
      EXPECT_EQ(trial.brep.face_of(h), FaceId(f));
      EXPECT_EQ(trial.brep.next_of(h), Brep::twin(h));
      EXPECT_EQ(sum(trial.brep), sum(brep));
      EXPECT_FALSE(trial.euler.kemr(h).valid());
      trial.expect_restored();
    }
}

TEST(Euler, AnInnerLoopGoesToAnotherPartOfItsFaceAndBack) {
  const Brep brep = structures()[1];
  for (const FaceId f : brep.faces()) {
    const LoopId inner = brep.next_loop[brep.outer_loop[f]];
    if (!inner.valid()) continue;
    Trial trial(brep);
    const HalfEdgeId a = brep.loop_half_edge[brep.outer_loop[f]];
    const HalfEdgeId h = trial.euler.mef(a, brep.next_of(brep.next_of(a)), Euler::NewFace::left);
    trial.euler.transfer_loop(inner, trial.brep.face_of(h));
    trial.expect_changed();
    EXPECT_EQ(trial.brep.loop_face[inner], trial.brep.face_of(h));
    trial.euler.transfer_loop(inner, f);
    trial.euler.kef(h);
    trial.expect_restored();
  }
}

// Long random sequences of the operators that make something; each is also undone and done again.
TEST(Euler, RandomSequencesKeepLinksAndSum) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    const auto starts = structures();
    Brep brep = starts[seed % starts.size()];
    for (int step = 0; step < 60; ++step) {
      const HalfEdgeId h(random() % brep.half_edge_count());
      std::vector<HalfEdgeId> others;
      for_each_in_face(brep, brep.face_of(h), [&](HalfEdgeId g) { others.push_back(g); });
      const HalfEdgeId other = others[random() % others.size()];
      Trial trial(brep);
      switch (random() % 3) {
        case 0:
          trial.euler.semv(h, PointId(2000 + static_cast<std::uint32_t>(step)));
          brep = trial.brep;
          trial.expect_changed();
          trial.euler.kev(trial.brep.vertex_half_edge.back());
          break;
        case 1:
          trial.euler.mev(h, h);
          brep = trial.brep;
          trial.expect_changed();
          trial.euler.kemr(HalfEdgeId(trial.brep.half_edge_count() - 1));
          break;
        default: {
          if (h == other) continue;
          const bool rings = brep.loop_of(h) != brep.loop_of(other);
          const HalfEdgeId made = trial.euler.connect(h, other);
          brep = trial.brep;
          trial.expect_changed();
          if (rings)
            trial.euler.kemr(made);
          else
            trial.euler.kef(made);
        }
      }
      trial.expect_restored();
      ASSERT_FALSE(HasFailure()) << "seed " << seed << " step " << step;
    }
  }
}

// As mev one after the other, but each half-edge moves once.
TEST(Euler, AChainOfVerticesIsTheSameAsOneVertexAfterTheOther) {
  const Solid solid = pyramid(2, 2, 7);
  Brep chain = solid.data()->brep();
  VertexId apex(0);
  const auto degree = [&](VertexId v) {
    int count = 0;
    for_each_around(chain, chain.vertex_half_edge[v], [&](HalfEdgeId) { ++count; });
    return count;
  };
  while (degree(apex) != 7) apex = VertexId(apex.value() + 1);
  std::vector<HalfEdgeId> around;
  for_each_around(chain, chain.vertex_half_edge[apex], [&](HalfEdgeId h) { around.push_back(h); });
  Brep single = chain;
  // Runs of two, none and three half-edges, and of none at the end; two stay.
  const std::vector<HalfEdgeId> first = {around[2], around[4], around[4], HalfEdgeId()};
  std::vector<HalfEdgeId> made, expected;
  HalfEdgeId end = around[0];
  for (const HalfEdgeId h : first) {
    expected.push_back(Euler(single).mev(h.valid() ? h : end, end));
    end = Brep::twin(expected.back());
  }
  Euler(chain).mev_chain(first, around[0], made);
  EXPECT_EQ(made, expected);
  EXPECT_EQ(chain.origin, single.origin);
  EXPECT_EQ(chain.next, single.next);
  EXPECT_EQ(chain.prev, single.prev);
  EXPECT_EQ(chain.loop, single.loop);
  EXPECT_EQ(chain.vertex_half_edge, single.vertex_half_edge);
  EXPECT_EQ(chain.point, single.point);
  EXPECT_EQ(broken_links(chain, false), std::vector<std::string>{});
}

}  // namespace
}  // namespace sectile
