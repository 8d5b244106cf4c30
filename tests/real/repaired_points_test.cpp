// Real meshes, repaired: are points in the solid as the winding numbers of the input say?
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <cstdint>
#include <optional>

#include "real/exact_winding.h"
#include "real/real_meshes.h"
#include "real/winding_check.h"
#include "sectile/sectile.h"

namespace sectile::test {
namespace {

using Kind = RepairChange::Kind;

// Polygons as fans: what they bound is then no matter of opinion.
PolygonMesh as_triangles(const PolygonMesh& mesh) {
  PolygonMesh result;
  result.positions = mesh.positions;
  std::size_t first = 0;
  for (const std::uint32_t size : mesh.face_sizes) {
    for (std::size_t k = 1; k + 1 < size; ++k) {
      result.face_sizes.push_back(3);
      for (const std::size_t i : {std::size_t(0), k, k + 1})
        result.indices.push_back(mesh.indices[first + i]);
    }
    first += size;
  }
  return result;
}

std::vector<std::optional<int>> windings(const PolygonMesh& mesh, const std::vector<Vec3>& points) {
  const ExactWinding winding(mesh);
  std::vector<std::optional<int>> result(points.size());
  tbb::parallel_for(std::size_t(0), points.size(),
                    [&](std::size_t i) { result[i] = winding(points[i]); });
  return result;
}

bool has(const RepairReport& report, Kind kind) {
  return std::any_of(report.changes.begin(), report.changes.end(),
                     [&](const RepairChange& c) { return c.kind == kind; });
}

// Does the mesh as it is have winding numbers that mean something by the rule?
bool is_comparable(const RepairReport& report, Rule rule) {
  if (has(report, Kind::removed_copies)) return false;
  if (has(report, Kind::turned_faces)) return rule == Rule::odd;
  return rule != Rule::positive || !has(report, Kind::turned_parts);
}

bool is_material(Rule rule, int winding) {
  return rule == Rule::positive  ? winding >= 1
         : rule == Rule::nonzero ? winding != 0
                                 : winding % 2 != 0;
}

class RepairedMeshesExhaustive : public testing::Test {
 protected:
  std::size_t meshes_ = 0, open_ = 0, compared_ = 0, points_ = 0;

  void check(const std::string& file) {
    SCOPED_TRACE(file);
    PolygonMesh mesh;
    try {
      mesh = as_triangles(read_mesh(file));
    } catch (const FileError&) {
      return;  // the table in docs/ says why
    }
    ++meshes_;
    const std::vector<Vec3> points = sample_points(mesh, 1000);
    const auto expected = windings(mesh, points);
    for (const Rule rule : {Rule::positive, Rule::nonzero, Rule::odd}) {
      SCOPED_TRACE(static_cast<int>(rule));
      RepairOptions options;
      options.rule = rule;
      RepairReport report;
      Solid solid;
      try {
        solid = repair(mesh, options, &report);
      } catch (const InvalidSolid& error) {
        if (error.reason() == InvalidSolid::Reason::open) {
          EXPECT_FALSE(report.holes.empty());
          ++open_;
          return;
        }
        EXPECT_NE(rule, Rule::odd) << error.what();
        continue;
      }
      if (is_comparable(report, rule)) compare(rule, expected, windings(solid.to_mesh(), points));
    }
  }

  void compare(Rule rule, const std::vector<std::optional<int>>& expected,
               const std::vector<std::optional<int>>& found) {
    ++compared_;
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      if (!expected[i] || !found[i]) continue;  // on a face
      ++points_;
      wrong += *found[i] != (is_material(rule, *expected[i]) ? 1 : 0);
    }
    EXPECT_EQ(wrong, 0u);
  }
};

TEST_F(RepairedMeshesExhaustive, PointsAreWhereTheWindingNumbersOfTheInputSay) {
  const std::vector<std::string> files = real_meshes();
  if (files.empty()) GTEST_SKIP() << "there are no meshes in " << SECTILE_REAL_MESHES;
  for (const std::string& file : files) check(file);
  std::printf("%zu meshes, %zu of them open; %zu solids compared at %zu points\n", meshes_, open_,
              compared_, points_);
  EXPECT_GT(compared_, meshes_);
}

// The program that counts is itself tried on what needs no counting.
TEST(ExactWinding, OfABoxAndOfOneInsideOut) {
  PolygonMesh box = block({0, 0, 0}, {2, 2, 2}).to_mesh();
  for (const int sign : {1, -1}) {
    const ExactWinding winding(box);
    // Beside edges, corners and diagonals of faces, as seen along x.
    for (const double y : {0.5, 1.0, 1.5})
      for (const double z : {0.5, 1.0, 1.5}) {
        EXPECT_EQ(winding({1, y, z}), sign);
        EXPECT_EQ(winding({-1, y, z}), 0);
        EXPECT_EQ(winding({3, y, z}), 0);
        EXPECT_EQ(winding({2 - 0x1p-52, y, z}), sign);
        EXPECT_EQ(winding({2, y, z}), std::nullopt);
      }
    EXPECT_EQ(winding({-1, 0, 0}), 0);
    EXPECT_EQ(winding({-1, 2, 1}), 0);
    std::reverse(box.indices.begin(), box.indices.end());
  }
}

}  // namespace
}  // namespace sectile::test
