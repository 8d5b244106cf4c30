// Large meshes of triangles come into blocks on a way of their own. It leads to the same solids,
// and to the same words for what is no solid, as that of all other meshes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <tuple>

#include "import/triangles/read_triangles.h"
#include "sectile/sectile.h"
#include "unit/large_meshes.h"

namespace sectile {
namespace {

std::vector<std::uint32_t> some_groups(const PolygonMesh& mesh, bool grouped) {
  std::vector<std::uint32_t> groups;
  for (std::uint32_t f = 0; grouped && f < mesh.face_sizes.size(); ++f)
    groups.push_back(f % 7 == 0 ? 1 : 0);
  return groups;
}

struct Import {
  Solid solid;
  std::vector<std::vector<std::uint32_t>> faces;  // those of the input in each of the solid
};

Import import_of(const PolygonMesh& mesh, bool grouped) {
  const std::vector<std::uint32_t> groups = some_groups(mesh, grouped);
  ImportOptions options;
  options.face_groups = groups;
  Import made{Solid::from_mesh(mesh, options), {}};
  std::vector<FaceSource> sources;
  boolean(made.solid, Solid(), Operation::unite).to_mesh(sources);
  for (const FaceSource& s : sources) made.faces.push_back(made.solid.joined_faces(s.face));
  std::sort(made.faces.begin(), made.faces.end());
  return made;
}

std::multiset<std::vector<double>> triangles_of(const PolygonMesh& mesh) {
  std::multiset<std::vector<double>> all;
  for (std::size_t f = 0; f < mesh.face_sizes.size(); ++f) {
    std::array<std::array<double, 3>, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = mesh.positions[mesh.indices[3 * f + k]];
      corners[k] = {p.x, p.y, p.z};
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    std::vector<double> numbers;
    for (const auto& c : corners) numbers.insert(numbers.end(), c.begin(), c.end());
    all.insert(numbers);
  }
  return all;
}

bool goes_straight(const PolygonMesh& mesh) {
  ImportOptions options;
  options.trusted = true;
  return read_triangles({mesh.positions, {}, mesh.face_sizes, mesh.indices}, options,
                        ImportSteps(options)) != nullptr;
}

void expect_same_both_ways(const PolygonMesh& mesh) {
  EXPECT_FALSE(goes_straight(with_face_without_area(mesh)));
  for (const bool grouped : {false, true}) {
    SCOPED_TRACE(grouped ? "in groups" : "without groups");
    const Import straight = import_of(mesh, grouped),
                 general = import_of(with_face_without_area(mesh), grouped);
    EXPECT_TRUE(grouped || validate(straight.solid).empty());
    EXPECT_TRUE(straight.solid == general.solid);
    const SolidCounts a = straight.solid.counts(), b = general.solid.counts();
    EXPECT_EQ(std::tie(a.vertices, a.edges, a.faces, a.loops, a.shells, a.genus),
              std::tie(b.vertices, b.edges, b.faces, b.loops, b.shells, b.genus));
    EXPECT_EQ(straight.solid.volume(), general.solid.volume());
    EXPECT_EQ(straight.faces, general.faces);
    EXPECT_EQ(triangles_of(straight.solid.to_mesh()), triangles_of(mesh));
  }
}

std::string refusal_of(const PolygonMesh& mesh) {
  try {
    Solid::from_mesh(mesh);
  } catch (const InvalidSolid& e) {
    return e.what();
  }
  return "";
}

void expect_same_refusal(const PolygonMesh& mesh) {
  const std::string said = refusal_of(mesh);
  EXPECT_NE(said, "");
  EXPECT_EQ(said, refusal_of(with_face_without_area(mesh)));
}

TEST(ImportTriangles, ABall) {
  EXPECT_TRUE(goes_straight(ball()));
  expect_same_both_ways(ball());
}

TEST(ImportTriangles, ABoulder) {
  EXPECT_TRUE(goes_straight(boulder(0)));
  expect_same_both_ways(boulder(0));
}

TEST(ImportTriangles, AScanOnAGrid) {
  EXPECT_TRUE(goes_straight(boulder(1.0 / 256)));
  expect_same_both_ways(boulder(1.0 / 256));
}

TEST(ImportTriangles, ManyFlatFaces) {
  EXPECT_TRUE(goes_straight(flattened_ball()));
  expect_same_both_ways(flattened_ball());
}

TEST(ImportTriangles, ARing) {
  EXPECT_TRUE(goes_straight(ring()));
  expect_same_both_ways(ring());
}

TEST(ImportTriangles, CornersOfTheirOwnInAnyOrder) {
  expect_same_both_ways(soup_of(boulder(0)));
  expect_same_both_ways(soup_of(flattened_ball()));
}

TEST(ImportTriangles, TwoShells) {
  expect_same_both_ways(both(boulder(0), ring()));
}

// A sausage whose ends meet in a point.
TEST(ImportTriangles, OneShellThatMeetsItselfInAPoint) {
  const PolygonMesh sausage = tube(46, 50, true, [](double u, double v) {
    const auto sine = [](double t) {
      return t > 0.5 ? -std::sin(2 * std::numbers::pi * (1 - t))
                     : std::sin(2 * std::numbers::pi * t);
    };
    const double b = 2 * std::numbers::pi * v, thick = 2 * u * (1 - u);
    const double r = 3 + thick * std::cos(b),
                 x = std::cos(2 * std::numbers::pi * std::min(u, 1 - u));
    return Vec3{r * x, r * sine(u), thick * std::sin(b)};
  });
  const Solid solid = Solid::from_mesh(sausage);
  EXPECT_EQ(solid.counts().shells, 1u);
  EXPECT_EQ(solid.counts().genus, 0);
  EXPECT_FALSE(goes_straight(sausage));
  expect_same_both_ways(sausage);
}

TEST(ImportTriangles, ShellsThatTouchInAPoint) {
  const auto spindle = [](double z) {
    return tube(32, 40, true, [z](double u, double v) {
      const double b = 2 * std::numbers::pi * v, r = 4 * u * (1 - u);
      return Vec3{r * std::cos(b), r * std::sin(b), z + 1 - 2 * u};
    });
  };
  expect_same_both_ways(both(spindle(0), spindle(2)));
}

// Around each edge of a circle there are four triangles.
TEST(ImportTriangles, RingsThatTouchInACircle) {
  const auto ring_around = [](double middle, double side) {
    return tube(32, 40, false, [=](double u, double v) {
      const double a = 2 * std::numbers::pi * u, b = 2 * std::numbers::pi * v;
      const double r = middle + side * std::cos(a);
      return Vec3{r * std::cos(b), r * std::sin(b), -side * std::sin(a)};
    });
  };
  EXPECT_FALSE(goes_straight(both(ring_around(2, 1), ring_around(4, -1))));
  expect_same_both_ways(both(ring_around(2, 1), ring_around(4, -1)));
}

TEST(ImportTriangles, RefusesInTheSameWords) {
  PolygonMesh open = boulder(0);
  open.indices.resize(open.indices.size() - 3);
  open.face_sizes.pop_back();
  expect_same_refusal(open);

  PolygonMesh turned = boulder(0);
  std::swap(turned.indices[3000], turned.indices[3001]);
  expect_same_refusal(turned);

  PolygonMesh inside_out = boulder(0);
  std::reverse(inside_out.indices.begin(), inside_out.indices.end());
  expect_same_refusal(inside_out);

  PolygonMesh crossing = boulder(0);
  crossing.positions[1234].x += 3;
  expect_same_refusal(crossing);

  PolygonMesh lost = boulder(0);
  lost.indices[500] = 1u << 30;
  expect_same_refusal(lost);

  PolygonMesh nowhere = boulder(0);
  nowhere.positions[77].y = std::nan("");
  expect_same_refusal(nowhere);

  PolygonMesh doubled = boulder(0);
  doubled.indices.insert(doubled.indices.end(), doubled.indices.begin(),
                         doubled.indices.begin() + 3);
  doubled.face_sizes.push_back(3);
  expect_same_refusal(doubled);
}

}  // namespace
}  // namespace sectile
