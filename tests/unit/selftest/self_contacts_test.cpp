// All pairs of triangles that meet as they must not, where very many triangles have a line in
// common: those that looking at each two of them finds.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "selftest/self_test.h"
#include "selftest/triangle_pair.h"

namespace sectile {
namespace {

// Leaves: wedges along the z axis, between two places on the rim of a square around it.
class Leaves {
 public:
  static constexpr int places = 192;

  void add(int first, int second, int low, int high, bool inside_out) {
    std::array<PointId, 6> at;
    for (std::size_t i = 0; i < 6; ++i) {
      const double z = i < 3 ? low : high;
      const auto [x, y] =
          i % 3 == 0 ? std::array{0.0, 0.0} : on_square(i % 3 == 1 ? first : second);
      at[i] = point({x + z, y, 4 * z});
    }
    const std::size_t begin = surface_.size();
    for (auto [a, b, c] : std::array<std::array<std::size_t, 3>, 8>{{{0, 2, 1},
                                                                     {3, 4, 5},
                                                                     {0, 1, 4},
                                                                     {0, 4, 3},
                                                                     {1, 2, 5},
                                                                     {1, 5, 4},
                                                                     {2, 0, 3},
                                                                     {2, 3, 5}}}) {
      if (inside_out) std::swap(b, c);
      surface_.corners.push_back({at[a], at[b], at[c]});
      surface_.plane.push_back(geometry_.add_plane(PlaneDefinition::through(at[a], at[b], at[c])));
      surface_.face.push_back(static_cast<std::uint32_t>(surface_.face.size()));
    }
    find_mates(begin);
  }

  using Pair = std::array<std::uint32_t, 3>;  // and the kind
  std::vector<Pair> found() const {
    std::vector<Pair> pairs;
    for (const SelfContact& c : self_contacts(surface_, Kernel(geometry_)))
      pairs.push_back(as_pair(c));
    return pairs;
  }
  std::vector<Pair> expected() const {
    std::vector<Pair> pairs;
    const Kernel kernel(geometry_);
    const TrianglePairs test(surface_, kernel);
    for (std::uint32_t s = 0; s < surface_.size(); ++s)
      for (std::uint32_t t = s + 1; t < surface_.size(); ++t)
        if (const auto contact = test.test(s, t)) pairs.push_back(as_pair(*contact));
    return pairs;
  }

 private:
  static Pair as_pair(const SelfContact& c) {
    return {c.first, c.second, static_cast<std::uint32_t>(c.kind)};
  }
  static std::array<double, 2> on_square(int at) {
    constexpr int half = places / 8, side = 2 * half;
    const double along = at % side - half;
    const std::array<double, 2> corners[] = {
        {half, along}, {-along, half}, {-half, -along}, {along, -half}};
    return corners[at / side % 4];
  }
  PointId point(const Vec3& p) {
    const auto [known, is_new] = points_.try_emplace({p.x, p.y, p.z});
    if (is_new) known->second = geometry_.add_point(p);
    return known->second;
  }
  void find_mates(std::size_t begin) {
    const auto edge = [&](std::size_t t, std::size_t k) {
      return std::pair(surface_.corners[t][k], surface_.corners[t][(k + 1) % 3]);
    };
    for (std::size_t s = begin; s < surface_.size(); ++s)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t t = begin; t < surface_.size(); ++t)
          for (std::size_t k = 0; k < 3; ++k)
            if (edge(s, j) == std::pair(edge(t, k).second, edge(t, k).first)) {
              surface_.mate.resize(surface_.size());
              surface_.mate[s][j] = static_cast<std::uint32_t>(t);
            }
  }

  Geometry geometry_;
  std::map<std::array<double, 3>, PointId> points_;
  TriangleSurface surface_;
};

class LeavesOnALine : public testing::TestWithParam<int> {};  // so many ends are on the line

TEST_P(LeavesOnALine, AllThatMeetAsTheyMustNotAreNamed) {
  const int ends = GetParam();
  int some = 0, none = 0;
  for (unsigned seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    Leaves leaves;
    const auto add = [&](int first, int widest, bool inside_out) {
      const int low = below(ends), high = low + 1 + below(ends - low);
      leaves.add(first, first + 1 + below(widest), low, high, inside_out);
    };
    for (int at = 0; at + 7 < Leaves::places; at += 8) add(at, 6, false);
    // Between the others, across some, in one of them, with a wall in one of theirs.
    for (int extra = below(3); extra > 0; --extra)
      add(below(160), below(2) == 0 ? 24 : 3, below(3) > 0);
    const auto expected = leaves.expected();
    ++(expected.empty() ? none : some);
    EXPECT_EQ(leaves.found(), expected);
  }
  EXPECT_GT(some, 20);
  EXPECT_GT(none, 10);
}

INSTANTIATE_TEST_SUITE_P(SelfTest, LeavesOnALine, testing::Values(1, 3, 12, 1000));

}  // namespace
}  // namespace sectile
