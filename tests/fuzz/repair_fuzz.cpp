// Any mesh becomes a legal solid by repair, by each rule, or is refused with InvalidSolid. Where
// the mesh was closed and oriented, points are in the solid as its winding numbers say.
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "fuzz/fuzzed_mesh.h"
#include "real/winding_check.h"
#include "sectile/sectile.h"

namespace sectile {
namespace {

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "violated: %s\n", what);
  std::abort();
}

bool is_as_it_was(const RepairReport& report) {
  using Kind = RepairChange::Kind;
  for (const RepairChange& change : report.changes)
    if (change.kind == Kind::turned_faces || change.kind == Kind::turned_parts ||
        change.kind == Kind::closed_holes || change.kind == Kind::removed_copies ||
        change.kind == Kind::split_polygons)
      return false;
  return true;
}

bool is_material(Rule rule, double winding) {
  const double w = std::round(winding);
  return rule == Rule::positive  ? w >= 1
         : rule == Rule::nonzero ? w != 0
                                 : std::fmod(std::abs(w), 2.0) == 1;
}

void check_points(const PolygonMesh& mesh, const Solid& solid, Rule rule) {
  const PolygonMesh result = solid.to_mesh();
  for (int i = 0; i < 27; ++i) {
    const Vec3 at{0.317 + i % 3, 0.241 + i / 3 % 3, 0.571 + i / 9};
    const double mine = test::winding_number(mesh, at), its = test::winding_number(result, at);
    if (std::abs(mine - std::round(mine)) > 1e-6 || std::abs(its - std::round(its)) > 1e-6)
      continue;
    require(is_material(rule, mine) == (std::round(its) == 1), "points are where they should be");
  }
}

}  // namespace
}  // namespace sectile

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sectile;
  Bytes bytes({data, size});
  PolygonMesh mesh = fuzzed_mesh(bytes);
  const PolygonMesh more = fuzzed_mesh(bytes);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), more.positions.begin(), more.positions.end());
  mesh.face_sizes.insert(mesh.face_sizes.end(), more.face_sizes.begin(), more.face_sizes.end());
  for (const std::uint32_t i : more.indices) mesh.indices.push_back(first + i);
  for (const Rule rule : {Rule::positive, Rule::nonzero, Rule::odd}) {
    RepairOptions options;
    options.rule = rule;
    options.close_holes = true;
    RepairReport report;
    Solid solid;
    try {
      solid = repair(mesh, options, &report);
    } catch (const InvalidSolid&) {
      continue;
    }
    for (const Violation& v : validate(solid)) {
      std::fprintf(stderr, "%s\n", v.what.c_str());
      require(false, "what was repaired is legal");
    }
    if (is_as_it_was(report)) check_points(mesh, solid, rule);
  }
  return 0;
}
