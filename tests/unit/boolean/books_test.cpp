// Very many thin walls that start from one line, in both operands: what the books are is what their
// pages are, one by one.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "cases.h"
#include "sectile/sectile.h"
#include "unit/brute_force_solid.h"
#include "unit/leaves.h"

namespace sectile {
namespace {

using test::add_leaf;
using test::is_accepted;
using test::Leaf;

// Half-planes around the z axis, which are numbered, make a turn.
constexpr int turn = 120;

struct Page {
  int first, second;  // half-planes
  double low, high;
  double size = 1;
};

Vec3 corner(const Page& page, int half_plane, double z) {
  const double angle = 2 * std::numbers::pi * half_plane / turn;
  return {page.size * std::cos(angle), page.size * std::sin(angle), z};
}

PolygonMesh mesh_of(std::span<const Page> pages) {
  PolygonMesh mesh;
  for (const Page& page : pages) {
    const auto o = static_cast<std::uint32_t>(mesh.positions.size());
    for (const double z : {page.low, page.high}) {
      mesh.positions.push_back({0, 0, z});
      mesh.positions.push_back(corner(page, page.first, z));
      mesh.positions.push_back(corner(page, page.second, z));
    }
    mesh.face_sizes.insert(mesh.face_sizes.end(), {3, 3, 4, 4, 4});
    for (const std::uint32_t k :
         {0u, 2u, 1u, 3u, 4u, 5u, 0u, 1u, 4u, 3u, 1u, 2u, 5u, 4u, 2u, 0u, 3u, 5u})
      mesh.indices.push_back(o + k);
  }
  return mesh;
}

Solid book(std::span<const Page> pages) {
  return Solid::from_mesh(mesh_of(pages));
}

std::vector<Solid> singly(std::span<const Page> pages) {
  std::vector<Solid> solids;
  for (const Page& page : pages) solids.push_back(book({&page, 1}));
  return solids;
}

using Stretches = std::vector<std::array<double, 2>>;

// Pages around the axis that have no wall in common, each with one of these stretches, or several.
std::vector<Page> random_pages(std::mt19937& random, std::span<const Stretches> stretches) {
  std::vector<Page> pages;
  const auto below = [&](std::size_t n) { return static_cast<int>(random() % n); };
  for (int at = below(2); at < turn;) {
    const int next = at + 1 + below(2);
    if (next > turn || (next == turn && !pages.empty() && pages[0].first == 0)) break;
    const double size = 1 + below(2);
    for (const auto& [low, high] : stretches[static_cast<std::size_t>(below(stretches.size()))])
      pages.push_back({at, next, low, high, size});
    at = next + 1 + below(2);
  }
  return pages;
}

bool have_room_in_common(const Page& p, const Page& q) {
  return std::max(p.first, q.first) < std::min(p.second, q.second) &&
         std::max(p.low, q.low) < std::min(p.high, q.high);
}

void expect_valid(const Solid& solid) {
  EXPECT_TRUE(validate(solid).empty());
}

void expect_what_pages_are(std::span<const Page> of_a, std::span<const Page> of_b, const Solid& a,
                           const Solid& b, std::span<const Solid> each_a,
                           std::span<const Solid> each_b) {
  std::vector<Solid> common, rest;
  for (std::size_t i = 0; i < of_a.size(); ++i) {
    std::vector<Solid> beside;
    for (std::size_t j = 0; j < of_b.size(); ++j) {
      if (!have_room_in_common(of_a[i], of_b[j])) continue;
      common.push_back(boolean(each_a[i], each_b[j], Operation::intersect));
      beside.push_back(each_b[j]);
    }
    rest.push_back(subtract(each_a[i], beside));
  }
  const Solid both = boolean(a, b, Operation::intersect), left = boolean(a, b, Operation::subtract),
              all = boolean(a, b, Operation::unite);
  for (const Solid& solid : {both, left, all}) expect_valid(solid);
  double volume = 0;
  for (const Solid& solid : common) volume += solid.volume();
  EXPECT_NEAR(both.volume(), volume, 1e-12 * (1 + volume));
  EXPECT_NEAR(left.volume(), a.volume() - volume, 1e-12 * a.volume());
  EXPECT_NEAR(all.volume(), a.volume() + b.volume() - volume, 1e-12 * a.volume());
  EXPECT_TRUE(both == unite(common));
  EXPECT_TRUE(left == unite(rest));
  std::vector<Solid> pages(each_a.begin(), each_a.end());
  pages.insert(pages.end(), each_b.begin(), each_b.end());
  EXPECT_TRUE(all == unite(pages));
}

void expect_what_pages_are(std::span<const Page> of_a, std::span<const Page> of_b,
                           const Transform& placed) {
  const auto place = [&](const Solid& solid) { return transformed(solid, placed); };
  std::vector<Solid> each_a = singly(of_a), each_b = singly(of_b);
  for (auto* each : {&each_a, &each_b})
    for (Solid& solid : *each) solid = place(solid);
  expect_what_pages_are(of_a, of_b, place(book(of_a)), place(book(of_b)), each_a, each_b);
}

const Transform upright;
const Transform slanted = Transform::rotation_degrees({1, 2, 3}, 40);

TEST(Books, OfOneLength) {
  for (unsigned seed = 0; seed < cases(6u); ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const Stretches a{{0, 2}}, b{{seed % 3 * 0.5, 3.0 - seed % 2}};
    const auto of_a = random_pages(random, {&a, 1}), of_b = random_pages(random, {&b, 1});
    expect_what_pages_are(of_a, of_b, seed % 2 == 0 ? upright : slanted);
  }
}

TEST(Books, OfPagesOfDifferentLengths) {
  const Stretches kinds[] = {{{0, 4}}, {{0, 2}}, {{1, 4}}, {{0, 1}, {2, 3}}, {{1, 2}, {3, 4}}};
  for (unsigned seed = 0; seed < cases(8u); ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const std::size_t of_each = 2 + seed % 4;
    const auto of_a = random_pages(random, std::span(kinds).first(of_each)),
               of_b = random_pages(random, std::span(kinds).last(of_each));
    expect_what_pages_are(of_a, of_b, seed % 2 == 0 ? upright : slanted);
  }
}

// Short edges, one after the other, along long ones.
TEST(Books, OfShortPagesBesideLongOnes) {
  const Stretches longer{{0, 8}}, shorter{{0, 1}, {1.5, 2}, {3, 5}, {7, 9}};
  for (unsigned seed = 0; seed < cases(3u); ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto of_a = random_pages(random, {&longer, 1}),
               of_b = random_pages(random, {&shorter, 1});
    expect_what_pages_are(of_a, of_b, seed % 2 == 0 ? upright : slanted);
  }
}

// Each page of a kind of its own: no two edges have both ends in common.
TEST(Books, OfPagesThatAreAllOfDifferentLengths) {
  std::vector<Page> of_a, of_b;
  for (int i = 0; i + 2 < turn; i += 3) {
    of_a.push_back({i, i + 2, 0, 2 + 0.01 * i});
    of_b.push_back({i + 1, i + 2, 1 - 0.001 * i, 3});
  }
  expect_what_pages_are(of_a, of_b, slanted);
}

// Very many lengths: pages far from each other are not compared along the line.
std::vector<Stretches> all_lengths(std::mt19937& random) {
  const auto below = [&](unsigned n) { return static_cast<double>(random() % n); };
  std::vector<Stretches> kinds;
  for (int i = 0; i < 200; ++i) {
    const double low = 0.01 * below(100), high = 4 - 0.01 * below(100);
    kinds.push_back({{low, high}});
    if (i % 4 == 0) kinds.back() = {{low, 1.5 + 0.01 * below(20)}, {2 - 0.01 * below(20), high}};
  }
  return kinds;
}

TEST(Books, OfPagesOfVeryManyLengths) {
  for (unsigned seed = 0; seed < cases(2u); ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const std::vector<Stretches> kinds = all_lengths(random);
    const auto of_a = random_pages(random, kinds), of_b = random_pages(random, kinds);
    expect_what_pages_are(of_a, of_b, seed % 2 == 0 ? upright : slanted);
  }
}

// Of one operand, one page is wide, or pages meet a body across the line, maybe with a slit that
// begins there.
TEST(Books, OfVeryManyLengthsWithMoreAtTheLine) {
  for (unsigned seed = 0; seed < cases(3u); ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const Transform& placed = seed % 2 == 0 ? upright : slanted;
    const std::vector<Stretches> kinds = all_lengths(random);
    const Solid a = transformed(book(random_pages(random, kinds)), placed),
                b = transformed(book(random_pages(random, kinds)), placed);
    Solid more = book(std::vector<Page>{{3, 3 + 50, 1.7, 1.8, 0.5}});
    if (seed % 3 == 0) more = block({-0.3, -0.4, 1.25}, {0.35, 0.45, 1.75});
    if (seed % 3 == 1)
      more = boolean(block({-0.3, -0.4, -1}, {0.35, 0.45, 5}), more, Operation::subtract);
    more = transformed(more, placed);
    const Solid with = boolean(b, more, Operation::unite),
                without = boolean(b, more, Operation::subtract),
                common = boolean(a, b, Operation::intersect),
                a_in_more = boolean(a, more, Operation::intersect);
    for (const Solid& solid : {with, without, common, a_in_more}) expect_valid(solid);
    EXPECT_TRUE(boolean(a, with, Operation::intersect) ==
                boolean(common, a_in_more, Operation::unite));
    EXPECT_TRUE(boolean(a, without, Operation::intersect) ==
                boolean(common, more, Operation::subtract));
    EXPECT_TRUE(boolean(a, without, Operation::unite) ==
                boolean(boolean(a, b, Operation::unite), boolean(more, a, Operation::subtract),
                        Operation::subtract));
    EXPECT_TRUE(boolean(a, with, Operation::subtract) ==
                boolean(boolean(a, b, Operation::subtract), more, Operation::subtract));
    EXPECT_TRUE(boolean(with, a, Operation::subtract) ==
                boolean(boolean(b, a, Operation::subtract), boolean(more, a, Operation::subtract),
                        Operation::unite));
  }
}

// A solid across the line is united with a book, or cut out of it: what the line runs through.
TEST(Books, WithASolidAcrossTheLine) {
  const Stretches kinds[] = {{{0, 4}}, {{0, 2}}, {{1, 4}}};
  for (unsigned seed = 0; seed < cases(6u); ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const Transform& placed = seed % 2 == 0 ? upright : slanted;
    const auto of_a = random_pages(random, kinds), of_b = random_pages(random, kinds);
    const Solid a = transformed(book(of_a), placed), b = transformed(book(of_b), placed);
    Solid across = block({-0.3, -0.4, 1.25}, {0.35, 0.45, 1.75});
    if (seed >= 2) across = transformed(across, Transform::rotation_degrees({1, 0, 1}, 10));
    across = transformed(across, placed);
    const Solid with = boolean(b, across, Operation::unite),
                without = boolean(b, across, Operation::subtract),
                common = boolean(a, b, Operation::intersect),
                in_a = boolean(a, across, Operation::intersect),
                out_of_a = boolean(a, across, Operation::subtract);
    EXPECT_TRUE(boolean(a, with, Operation::intersect) == boolean(common, in_a, Operation::unite));
    EXPECT_TRUE(boolean(a, without, Operation::intersect) ==
                boolean(common, across, Operation::subtract));
    EXPECT_TRUE(boolean(out_of_a, without, Operation::intersect) ==
                boolean(common, across, Operation::subtract));
    EXPECT_TRUE(boolean(out_of_a, without, Operation::unite) ==
                boolean(boolean(a, b, Operation::unite), across, Operation::subtract));
    EXPECT_TRUE(boolean(without, a, Operation::subtract) ==
                boolean(boolean(b, a, Operation::subtract), across, Operation::subtract));
    EXPECT_TRUE(boolean(a, with, Operation::subtract) ==
                boolean(boolean(a, b, Operation::subtract), across, Operation::subtract));
    for (const Solid& solid : {with, without, common, out_of_a}) expect_valid(solid);
  }
}

// In one arrangement of all faces: edges along the line end within others, of both books and of
// one.
void expect_cells_are_what_booleans_say(const Solid& a, const Solid& b) {
  const std::vector<Solid> both{a, b};
  const std::vector<SolidCell> all = cells(both);
  EXPECT_EQ(all.size(), 3u);
  for (const SolidCell& cell : all) {
    const Solid expected = cell.operands.size() == 2 ? boolean(a, b, Operation::intersect)
                           : cell.operands[0] == 0   ? boolean(a, b, Operation::subtract)
                                                     : boolean(b, a, Operation::subtract);
    EXPECT_TRUE(cell.solid == expected);
    expect_valid(cell.solid);
  }
}

TEST(Books, CellsAreWhatBooleansSay) {
  const Stretches kinds[] = {{{0, 4}}, {{0, 2}}, {{1, 4}}, {{0, 1}, {2, 3}}};
  for (unsigned seed = 0; seed < cases(4u); ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const Transform& placed = seed % 2 == 0 ? upright : slanted;
    const auto some = std::span(kinds).first(1 + seed);
    const Solid a = transformed(book(random_pages(random, some)), placed),
                b = transformed(book(random_pages(random, some)), placed),
                higher = transformed(transformed(book(random_pages(random, some)),
                                                 Transform::translation({0, 0, 1})),
                                     placed);
    for (const Solid& other : {b, higher}) expect_cells_are_what_booleans_say(a, other);
  }
}

TEST(Books, CellsOfPagesThatAreAllOfDifferentLengths) {
  std::mt19937 random(1);
  std::vector<Stretches> kinds;
  for (int i = 0; i < 60; ++i) kinds.push_back({{0.01 * (37 * i % 60), 4 - 0.01 * (23 * i % 60)}});
  const std::vector<Page> of_a = random_pages(random, kinds), of_b = random_pages(random, kinds);
  const Solid a = transformed(book(std::span(of_a).first(26)), slanted),
              b = transformed(book(std::span(of_b).first(12)), slanted);
  expect_cells_are_what_booleans_say(a, b);
  // The line runs through the inside of one of its faces.
  expect_cells_are_what_booleans_say(a, transformed(block({0, -3, -3}, {3, 3, 3}), slanted));
}

TEST(Books, RepairUnitesThoseThatCross) {
  const Stretches kinds[] = {{{0, 4}}, {{0, 2}}, {{1, 4}}};
  for (unsigned seed = 0; seed < cases(3u); ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto of_a = random_pages(random, kinds), of_b = random_pages(random, kinds);
    std::vector<Page> all = of_a;
    all.insert(all.end(), of_b.begin(), of_b.end());
    const Solid repaired = repair(mesh_of(all));
    EXPECT_TRUE(repaired == boolean(book(of_a), book(of_b), Operation::unite));
    expect_valid(repaired);
  }
}

// A bouquet of n thin tetrahedra, whose common corner is where the others' edges run through.
Solid bouquet_in_the_line(std::size_t n, double z) {
  PolygonMesh mesh;
  for (std::size_t i = 0; i < n; ++i) {
    const auto o = static_cast<std::uint32_t>(mesh.positions.size());
    const double a = 2 * std::numbers::pi * (static_cast<double>(i) + 0.1) / static_cast<double>(n),
                 b = a + std::numbers::pi / static_cast<double>(n), up = i % 2 == 0 ? 0.3 : -0.25;
    mesh.positions.push_back({0, 0, z});
    mesh.positions.push_back({std::cos(a), std::sin(a), z + up});
    mesh.positions.push_back({std::cos(b), std::sin(b), z + up});
    mesh.positions.push_back({std::cos(a), std::sin(a), z + 2 * up});
    for (const std::uint32_t k : {0u, 2u, 1u, 0u, 1u, 3u, 0u, 3u, 2u, 1u, 2u, 3u})
      mesh.indices.push_back(o + (up > 0 || k == 0 ? k : k == 1 ? 1u : 5 - k));
    mesh.face_sizes.insert(mesh.face_sizes.end(), 4, 3);
  }
  return Solid::from_mesh(mesh);
}

TEST(Books, WithABouquetInTheLine) {
  const Stretches kinds[] = {{{0, 4}}, {{0, 2}}, {{1, 4}}};
  for (unsigned seed = 0; seed < cases(3u); ++seed) {
    for (const double z : {1.5, 2.0, 4.0}) {
      SCOPED_TRACE(z);
      std::mt19937 random(seed);
      const auto pages = random_pages(random, kinds);
      const Solid a = book(pages), b = bouquet_in_the_line(40, z);
      std::vector<Solid> common;
      for (const Solid& page : singly(pages))
        common.push_back(boolean(page, b, Operation::intersect));
      const Solid both = boolean(a, b, Operation::intersect);
      EXPECT_TRUE(both == unite(common));
      EXPECT_TRUE(boolean(boolean(a, b, Operation::subtract), both, Operation::unite) == a);
      EXPECT_TRUE(boolean(boolean(b, a, Operation::subtract), both, Operation::unite) == b);
    }
  }
}

struct Tally {
  int legal = 0, illegal = 0;
};

void compare(const PolygonMesh& mesh, Tally& tally) {
  const bool is_legal = test::BruteForceSolid(mesh).is_legal();
  ++(is_legal ? tally.legal : tally.illegal);
  EXPECT_EQ(is_accepted(mesh), is_legal);
}

// Legal books with one more leaf, which lies anywhere: between the others, across some, in one of
// them, with a wall in one of theirs.
TEST(Books, AreRefusedWhereTheyAreNoSolid) {
  Tally tally;
  for (unsigned seed = 0; seed < cases(400u); ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    PolygonMesh mesh;
    for (int at = 0; at + 8 < 192; at += 9) {
      const int low = seed % 3 == 0 ? 0 : below(2), high = seed % 3 < 2 ? 3 : 2 + below(2);
      if (below(12) == 0)
        add_leaf({at, at + 2, 0, 1}, seed % 2 != 0, mesh);
      else
        add_leaf({at, at + 5, low, high}, seed % 2 != 0, mesh);
    }
    const int at = below(160), low = below(3);
    add_leaf(
        {at, at + 1 + below(seed % 5 == 0 ? 24 : 4), low, low + 1 + below(4 - low), below(4) == 0},
        seed % 2 != 0, mesh);
    compare(mesh, tally);
  }
  EXPECT_GT(tally.legal, cases(30));
  EXPECT_GT(tally.illegal, cases(100));
}

// The same where the edges on the line have ends of their own, and no corner is one of many.
TEST(Books, OfAllLengthsAreRefusedWhereTheyAreNoSolid) {
  Tally tally;
  for (unsigned seed = 0; seed < cases(300u); ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    PolygonMesh mesh;
    for (int at = 0; at + 4 < 192; at += 5) {
      const bool is_short = below(12) == 0;
      const int low = is_short ? 10 * below(8) : below(40);
      add_leaf({at, at + 1 + below(3), low, is_short ? low + 8 : 41 + below(40)}, seed % 2 != 0,
               mesh);
    }
    const int at = below(160), low = below(60);
    add_leaf(
        {at, at + 1 + below(seed % 5 == 0 ? 24 : 3), low, low + 1 + below(80 - low), below(4) == 0},
        seed % 2 != 0, mesh);
    compare(mesh, tally);
  }
  EXPECT_GT(tally.legal, cases(30));
  EXPECT_GT(tally.illegal, cases(100));
}

}  // namespace
}  // namespace sectile
