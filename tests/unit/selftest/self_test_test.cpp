// The self-test against the definition, on meshes that are legal, touch, overlap, nest and cross.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "append_mesh.h"
#include "cases.h"
#include "import/soup.h"
#include "sectile/sectile.h"
#include "unit/brute_force_solid.h"
#include "unit/walls_through_a_point.h"

namespace sectile {
namespace {

using test::BruteForceSolid;

bool accepted(const PolygonMesh& mesh) {
  try {
    Solid::from_mesh(mesh);
    return true;
  } catch (const InvalidSolid&) {
    return false;
  }
}

void add_triangle(PolygonMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  mesh.face_sizes.push_back(3);
  mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

struct Corner {
  int x, y, z;
};

// A convex piece, turned inside out on request.
class Pieces {
 public:
  explicit Pieces(unsigned seed) : random_(seed) {}

  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

  PolygonMesh mesh(int count, int size, bool perturbed) {
    PolygonMesh all;
    for (int i = 0; i < count; ++i) add_piece(all, size, perturbed);
    return all;
  }

 private:
  void add_piece(PolygonMesh& all, int size, bool perturbed) {
    const bool inside_out = below(4) == 0;
    const int kind = below(3);
    std::vector<Corner> corners;
    std::vector<std::array<std::uint32_t, 3>> faces;
    if (kind == 0) {
      for (int i = 0; i < 4; ++i) corners.push_back(corner(size));
      faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
      const Corner &a = corners[0], &b = corners[1], &c = corners[2], &d = corners[3];
      const int det = (b.x - a.x) * ((c.y - a.y) * (d.z - a.z) - (c.z - a.z) * (d.y - a.y)) -
                      (b.y - a.y) * ((c.x - a.x) * (d.z - a.z) - (c.z - a.z) * (d.x - a.x)) +
                      (b.z - a.z) * ((c.x - a.x) * (d.y - a.y) - (c.y - a.y) * (d.x - a.x));
      if (det < 0) std::swap(corners[0], corners[1]);
    } else {
      const Corner low{below(size), below(size), below(size)};
      const Corner high{low.x + 1 + below(size - low.x), low.y + 1 + below(size - low.y),
                        low.z + 1 + below(size - low.z)};
      const bool prism = kind == 2;
      for (int i = 0; i < 8; ++i)
        corners.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
      if (prism)
        faces = {{0, 2, 1}, {4, 5, 6}, {0, 1, 5}, {0, 5, 4},
                 {0, 4, 6}, {0, 6, 2}, {1, 2, 6}, {1, 6, 5}};
      else
        faces = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                 {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    }
    const auto first = static_cast<std::uint32_t>(all.positions.size());
    for (const Corner& c : corners) {
      Vec3 p{16.0 * c.x, 16.0 * c.y, 16.0 * c.z};
      if (perturbed && below(4) == 0)
        p = {p.x + below(5) - 2, p.y + below(5) - 2, p.z + below(5) - 2};
      all.positions.push_back(p);
    }
    for (auto [a, b, c] : faces) {
      if (inside_out) std::swap(b, c);
      add_triangle(all, first + a, first + b, first + c);
    }
  }
  Corner corner(int size) { return {below(size + 1), below(size + 1), below(size + 1)}; }

  std::mt19937 random_;
};

struct Tally {
  int legal = 0, illegal = 0;
};

void compare(const PolygonMesh& mesh, Tally& tally) {
  const BruteForceSolid reference(mesh);
  if (reference.has_flat_triangle()) return;
  const bool legal = reference.is_legal();
  ++(legal ? tally.legal : tally.illegal);
  ASSERT_EQ(accepted(mesh), legal);
}

class RandomPieces : public testing::TestWithParam<std::array<int, 3>> {};

TEST_P(RandomPieces, AreRefusedWhereTheyAreNoSolid) {
  const auto [count, size, perturbed] = GetParam();
  Tally tally;
  Pieces pieces(static_cast<unsigned>(100 * count + 10 * size + perturbed));
  for (int i = 0; i < 1500; ++i) {
    SCOPED_TRACE(i);
    compare(pieces.mesh(count, size, perturbed != 0), tally);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(tally.illegal, 50);
  EXPECT_GT(tally.legal, 5);
}

std::string name_of_pieces(const testing::TestParamInfo<std::array<int, 3>>& test) {
  const auto [count, size, perturbed] = test.param;
  return std::to_string(count) + "Of" + std::to_string(size) + (perturbed ? "Perturbed" : "");
}

INSTANTIATE_TEST_SUITE_P(SelfTest, RandomPieces,
                         testing::Values(std::array{1, 3, 1}, std::array{2, 2, 0},
                                         std::array{2, 3, 0}, std::array{2, 3, 1},
                                         std::array{2, 6, 1}, std::array{3, 3, 0},
                                         std::array{3, 5, 0}, std::array{4, 6, 0}),
                         name_of_pieces);

// A plate of square cells, some of which are missing: its sides are flat pieces of many triangles.
PolygonMesh plate_of_cells(Pieces& pieces, std::uint32_t side) {
  std::vector<bool> there;
  for (std::uint32_t i = 0; i < side * side; ++i) there.push_back(pieces.below(5) != 0);
  const auto cell = [&](std::uint32_t x, std::uint32_t y) {
    return x < side && y < side && there[y * side + x];
  };
  PolygonMesh mesh;
  for (std::uint32_t z = 2; z < 4; ++z)
    for (std::uint32_t y = 0; y <= side; ++y)
      for (std::uint32_t x = 0; x <= side; ++x)
        mesh.positions.push_back({16.0 * x, 16.0 * y, 16.0 * z});
  const auto add = [&](const std::array<std::array<std::uint32_t, 3>, 4>& square) {
    std::array<std::uint32_t, 4> c;
    for (std::size_t k = 0; k < 4; ++k)
      c[k] = (square[k][2] * (side + 1) + square[k][1]) * (side + 1) + square[k][0];
    const unsigned from = pieces.below(2) == 0 ? 0 : 1;  // a diagonal
    add_triangle(mesh, c[from], c[from + 1], c[from + 2]);
    add_triangle(mesh, c[from], c[from + 2], c[(from + 3) % 4]);
  };
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x) {
      if (!cell(x, y)) continue;
      const std::uint32_t u = x + 1, v = y + 1;
      add({{{x, y, 1}, {u, y, 1}, {u, v, 1}, {x, v, 1}}});
      add({{{x, y, 0}, {x, v, 0}, {u, v, 0}, {u, y, 0}}});
      if (!cell(x, y - 1)) add({{{x, y, 0}, {u, y, 0}, {u, y, 1}, {x, y, 1}}});
      if (!cell(x, v)) add({{{u, v, 0}, {x, v, 0}, {x, v, 1}, {u, v, 1}}});
      if (!cell(x - 1, y)) add({{{x, v, 0}, {x, y, 0}, {x, y, 1}, {x, v, 1}}});
      if (!cell(u, y)) add({{{u, y, 0}, {u, v, 0}, {u, v, 1}, {u, y, 1}}});
    }
  return mesh;
}

// Pieces that stand on a plate, pass through its holes or through itself, or lie in its planes.
TEST(SelfTest, PlatesAmongPiecesAreRefusedWhereTheyAreNoSolid) {
  Tally tally;
  Pieces pieces(5);
  for (int i = 0; i < 2000; ++i) {
    SCOPED_TRACE(i);
    PolygonMesh mesh = plate_of_cells(pieces, 4);
    test::append(pieces.mesh(1 + i % 2, 4, i % 3 == 0), mesh);
    compare(mesh, tally);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(tally.illegal, 50);
  EXPECT_GT(tally.legal, 20);
}

// A globe of triangles that is bent, twisted and pressed through itself.
PolygonMesh bent_globe(std::mt19937& random) {
  const auto real = [&] { return static_cast<double>(random() % 1000) / 1000; };
  const double twist = 6 * real(), bend = 3 * real(), press = 1.6 * real(),
               roughness = 0.25 * real();
  constexpr std::uint32_t rings = 14, segments = 24;
  PolygonMesh mesh;
  const auto add = [&](double x, double y, double z) {
    const double scale = 1 + roughness * (real() - 0.5), angle = twist * z;
    const double px = scale * (x * std::cos(angle) - y * std::sin(angle)) + bend * z * z - bend / 3;
    const double py = scale * (x * std::sin(angle) + y * std::cos(angle));
    const double pz = scale * z * (1 - press * (x * x + y * y));
    mesh.positions.push_back({std::round(25 * px), std::round(60 * py), std::round(60 * pz)});
  };
  constexpr double pi = 3.14159265358979;
  add(0, 0, -1);
  for (std::uint32_t r = 1; r < rings; ++r)
    for (std::uint32_t s = 0; s < segments; ++s) {
      const double polar = pi * r / rings, around = 2 * pi * s / segments;
      add(std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), -std::cos(polar));
    }
  add(0, 0, 1);
  const std::uint32_t top = 1 + (rings - 1) * segments;
  for (std::uint32_t s = 0; s < segments; ++s) {
    const std::uint32_t next = (s + 1) % segments;
    add_triangle(mesh, 0, 1 + next, 1 + s);
    add_triangle(mesh, top, top - segments + s, top - segments + next);
    for (std::uint32_t r = 0; r + 2 < rings; ++r) {
      const std::uint32_t below = 1 + r * segments, above = below + segments;
      add_triangle(mesh, below + s, below + next, above + next);
      add_triangle(mesh, below + s, above + next, above + s);
    }
  }
  return mesh;
}

TEST(SelfTest, BentGlobesAreRefusedWhereTheyCrossThemselves) {
  std::mt19937 random(7);
  Tally tally;
  for (int i = 0; i < 150; ++i) {
    SCOPED_TRACE(i);
    compare(bent_globe(random), tally);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(tally.legal, 10);
  EXPECT_GT(tally.illegal, 10);
}

TEST(SelfTest, EveryPairOfACrossingGlobeIsNamed) {
  std::mt19937 random(11);
  int compared = 0;
  for (int i = 0; i < cases(40); ++i) {
    const PolygonMesh mesh = bent_globe(random);
    const BruteForceSolid reference(mesh);
    if (reference.has_flat_triangle()) continue;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> named;
    try {
      Solid::from_mesh(mesh);
    } catch (const InvalidSolid& error) {
      if (error.contacts().empty()) continue;  // refused for another reason
      for (const FaceContact& c : error.contacts()) named.emplace_back(c.face, c.other);
    }
    for (std::uint32_t f = 0; f < mesh.face_sizes.size(); ++f)
      for (std::uint32_t g = f + 1; g < mesh.face_sizes.size(); ++g)
        if (reference.interiors_meet(f, g)) {
          ASSERT_TRUE(std::binary_search(named.begin(), named.end(), std::pair(f, g)))
              << f << ' ' << g;
        }
    ++compared;
  }
  EXPECT_GT(compared, cases(40) / 4);
}

// [low, high]³ as squares, in one of several orders.
void add_cube(PolygonMesh& mesh, double low, double high, unsigned rotation, bool reversed) {
  std::vector<std::array<std::uint32_t, 4>> faces{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                                  {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  if (reversed) std::reverse(faces.begin(), faces.end());
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (unsigned i = 0; i < 8; ++i)
    mesh.positions.push_back({i & 1 ? high : low, i & 2 ? high : low, i & 4 ? high : low});
  for (const auto& f : faces) {
    mesh.face_sizes.push_back(4);
    for (unsigned k = 0; k < 4; ++k) mesh.indices.push_back(first + f[(k + rotation) % 4]);
  }
}

TEST(SelfTest, CrossingCubesAreRefusedInEveryOrder) {
  for (unsigned order = 0; order < 16; ++order) {
    PolygonMesh mesh;
    const bool swapped = (order & 1) != 0, reversed = (order & 2) != 0;
    const unsigned rotation = order >> 2;
    add_cube(mesh, swapped ? 0.5 : 0, swapped ? 2 : 1, rotation, reversed);
    add_cube(mesh, swapped ? 0 : 0.5, swapped ? 1 : 2, rotation, reversed);
    try {
      Solid::from_mesh(mesh);
      ADD_FAILURE() << "accepted in order " << order;
    } catch (const InvalidSolid& error) {
      EXPECT_EQ(error.reason(), InvalidSolid::Reason::self_intersecting);
      EXPECT_EQ(error.contacts().size(), 6u);
      ASSERT_TRUE(error.where());
      for (const double c : {error.where()->x, error.where()->y, error.where()->z}) {
        EXPECT_GE(c, 0.5);
        EXPECT_LE(c, 1);
      }
      EXPECT_LT(error.face(), 6u);
      EXPECT_GE(error.contacts().front().other, 6u);
    }
  }
}

TEST(SelfTest, SolidsBeyondFloatsAreTestedAsOthers) {
  // 260 triangles: the last eight boxes are not all there.
  PolygonMesh globe = sphere_mesh({0, 0, 0}, 1e200, 13, 11);
  EXPECT_TRUE(accepted(globe));
  const PolygonMesh other = sphere_mesh({1e200, 0, 0}, 1e200, 13, 11);
  const auto first = static_cast<std::uint32_t>(globe.positions.size());
  globe.positions.insert(globe.positions.end(), other.positions.begin(), other.positions.end());
  globe.face_sizes.insert(globe.face_sizes.end(), other.face_sizes.begin(), other.face_sizes.end());
  for (const std::uint32_t corner : other.indices) globe.indices.push_back(first + corner);
  EXPECT_FALSE(accepted(globe));
}

TEST(SelfTest, WhoPromisesIsNotChecked) {
  PolygonMesh mesh;
  add_cube(mesh, 0, 1, 0, false);
  add_cube(mesh, 3, 4, 0, false);
  ImportOptions promised;
  promised.trusted = true;
  EXPECT_EQ(Solid::from_mesh(mesh, promised), Solid::from_mesh(mesh));
  add_cube(mesh, 3.5, 4.5, 0, false);
  EXPECT_THROW(Solid::from_mesh(mesh), InvalidSolid);
}

TEST(SelfTest, CanBeCancelledAndTellsHowFarItIs) {
  const PolygonMesh mesh = sphere(1, 200, 100).to_mesh();
  std::atomic<bool> cancel{true};
  ImportOptions cancelled;
  cancelled.cancel = &cancel;
  EXPECT_THROW(Solid::from_mesh(mesh, cancelled), Cancelled);
  std::atomic<int> calls{0};
  std::atomic<bool> whole{false};
  ImportOptions told;
  told.progress = [&](double done) {
    ++calls;
    if (done == 1) whole = true;
  };
  Solid::from_mesh(mesh, told);
  EXPECT_GT(calls, 1);
  EXPECT_TRUE(whole);
}

// Fans around a hub, told apart by directions.
TEST(SelfTest, SharpConesAreToldApartByDirections) {
  constexpr std::uint32_t count = 2000;
  PolygonMesh mesh;
  mesh.positions = {{0, 0, 100}, {0, 0, -100}};
  for (std::uint32_t i = 0; i < count; ++i) {
    const double angle = 2 * 3.14159265358979 * i / count;
    mesh.positions.push_back({std::cos(angle), std::sin(angle), 0});
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t a = 2 + i, b = 2 + (i + 1) % count;
    add_triangle(mesh, 0, a, b);
    add_triangle(mesh, 1, b, a);
  }
  EXPECT_TRUE(accepted(mesh));
  std::swap(mesh.positions[2 + 100], mesh.positions[2 + 1000]);
  EXPECT_FALSE(accepted(mesh));
}

// A cone's sides meet its base in their own edges, but not everything does.
TEST(SelfTest, WhatPiercesTheBaseOfAConeIsFound) {
  const PolygonMesh standing = cone(1, 0, 1, 200).to_mesh();
  EXPECT_TRUE(accepted(standing));
  PolygonMesh pierced = standing;
  const auto first = static_cast<std::uint32_t>(pierced.positions.size());
  for (const Vec3& p :
       {Vec3{0.3, 0.2, -0.1}, {0.31, 0.2, -0.1}, {0.3, 0.21, -0.1}, {0.3, 0.2, 0.1}})
    pierced.positions.push_back(p);
  add_triangle(pierced, first, first + 2, first + 1);
  add_triangle(pierced, first, first + 1, first + 3);
  add_triangle(pierced, first + 1, first + 2, first + 3);
  add_triangle(pierced, first + 2, first, first + 3);
  EXPECT_FALSE(accepted(pierced));
}

// Spikes from two corners, each past the other one, in all directions that fit. A spike of one
// meets one of the other only where both are in one plane with the corners.
PolygonMesh fans_into_each_other(std::uint32_t spikes) {
  PolygonMesh mesh;
  mesh.positions = {{0, 0, 0}, {0.1, 0.2, 1}};
  std::mt19937 random(1);
  const auto number = [&] { return static_cast<double>(random() % 1000000) / 1e6 - 0.5; };
  for (std::uint32_t i = 0; i < 2 * spikes; ++i) {
    const Vec3& other = mesh.positions[1 - i % 2];
    const Vec3 end{other.x + number(), other.y + number(), other.z};
    const auto a = static_cast<std::uint32_t>(mesh.positions.size()), b = a + 1, c = a + 2;
    constexpr double size = 1e-7;
    mesh.positions.push_back({end.x + size, end.y, end.z});
    mesh.positions.push_back({end.x, end.y + size, end.z});
    mesh.positions.push_back({end.x - size, end.y - size, end.z});
    const std::uint32_t hub = i % 2;
    for (const auto& [p, q] : {std::pair{a, b}, {b, c}, {c, a}})
      hub == 0 ? add_triangle(mesh, hub, q, p) : add_triangle(mesh, hub, p, q);
    hub == 0 ? add_triangle(mesh, a, b, c) : add_triangle(mesh, a, c, b);
  }
  return mesh;
}

TEST(SelfTest, FansThatReachIntoEachOther) {
  EXPECT_TRUE(accepted(fans_into_each_other(600)));
}

TEST(SelfTest, OneSpikeThatMeetsOneOfAnotherFanIsFound) {
  PolygonMesh mesh = fans_into_each_other(600);
  // The end of one spike of the second corner is in the middle of one of the first.
  const Vec3 first = mesh.positions[2 + 3 * 200];
  const std::size_t end = 2 + 3 * 301;
  const Vec3 by{0.6 * first.x - 3e-8 - mesh.positions[end].x, 0.6 * first.y - mesh.positions[end].y,
                0.6 * first.z - mesh.positions[end].z};
  for (std::size_t i = end; i < end + 3; ++i) {
    Vec3& p = mesh.positions[i];
    p = {p.x + by.x, p.y + by.y, p.z + by.z};
  }
  EXPECT_FALSE(accepted(mesh));
}
// Each two walls have the point of all in common, which is within an edge of both.
TEST(SelfTest, WallsThroughOnePoint) {
  for (const double thickness : {0.1, 0.9}) {
    test::WallsThroughAPoint walls;
    walls.count = 400;
    walls.thickness = thickness;
    EXPECT_EQ(Solid::from_mesh(walls.mesh()).counts().shells, 400u);
  }
}

TEST(SelfTest, OneWallThatCrossesOthersInTheirPointIsFound) {
  test::WallsThroughAPoint walls, across;
  across.mirrored = true;
  PolygonMesh mesh = walls.mesh();
  across.add(5, mesh);
  EXPECT_FALSE(accepted(mesh));
}

TEST(SelfTest, OneWallThatPassesThePointOfOthersByAHair) {
  test::WallsThroughAPoint walls, passing;
  walls.count = passing.count = 100;
  for (const bool outwards : {true, false}) {
    passing.off = outwards ? 0x1p-20 : -0x1p-20;
    PolygonMesh mesh;
    for (int i = 0; i < walls.count; ++i) (i == 7 ? passing : walls).add(i, mesh);
    EXPECT_EQ(accepted(mesh), outwards);
  }
}

TEST(SelfTest, PolygonsThatPassThroughACornerOfTheirsAreNoFaces) {
  // The outer loop comes back through the corner (2, 0) onto its first edge and crosses there.
  Soup soup;
  const std::vector<Vec3> outline{{0, 0, 0},  {4, 0, 0},  {4, 4, 0}, {2, 0, 0},
                                  {3, -2, 0}, {1, -2, 0}, {0, 4, 0}};
  for (const double z : {0.0, 1.0})
    for (const Vec3& p : outline) soup.positions.push_back({p.x, p.y, z});
  const auto n = static_cast<std::uint32_t>(outline.size());
  const auto add = [&](std::vector<std::uint32_t> face) {
    soup.face_loops.push_back(1);
    soup.loop_sizes.push_back(static_cast<std::uint32_t>(face.size()));
    soup.indices.insert(soup.indices.end(), face.begin(), face.end());
  };
  std::vector<std::uint32_t> bottom, top;
  for (std::uint32_t i = 0; i < n; ++i) {
    top.push_back(n + i);
    bottom.push_back(n - 1 - i);
    const std::uint32_t j = (i + 1) % n;
    add({i, j, n + j, n + i});
  }
  add(top);
  add(bottom);
  EXPECT_THROW(import_soup(soup), InvalidSolid);
}

}  // namespace
}  // namespace sectile
