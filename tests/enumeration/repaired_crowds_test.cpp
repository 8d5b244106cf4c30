// Crowds in one mesh, some of their parts inside out: repaired by each rule against the cells of
// the parts as solids, of which the windings are known. In builds with SECTILE_SMALL_CROWDS what is
// around a line of few edges is a row, as it is around a line of very many.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "append_mesh.h"
#include "cases.h"
#include "crowds.h"
#include "sectile/arrangement.h"
#include "sectile/repair.h"
#include "sectile/sectile.h"
#include "unit/leaves.h"

namespace sectile::test {
namespace {

PolygonMesh turned(PolygonMesh mesh) {
  auto corner = mesh.indices.begin();
  for (const std::uint32_t size : mesh.face_sizes) {
    std::reverse(corner, corner + size);
    corner += size;
  }
  return mesh;
}

class CrowdInOneMesh {
 public:
  CrowdInOneMesh(unsigned seed, const KindOfCrowd& kind, int parts) : random_(seed) {
    CrowdOfFaces crowd(random_);
    for (int i = 0; i < parts; ++i) add(crowd.make(kind.kind, 1), random_() % 2 == 0);
    for (int i = 0; i < 2; ++i) add_beside_axis();
    // All of it once more in something: by the rule `positive` no part is inside out then.
    add(block({-4000, -4000, -4000}, {4000, 4000, 4000}).to_mesh(), false);
  }

  Solid repaired(Rule rule) const {
    RepairOptions options;
    options.rule = rule;
    return repair(mesh_, options);
  }

  Solid wanted(Rule rule) const {
    std::vector<Solid> material;
    for (const SolidCell& cell : cells(solids_)) {
      int winding = 0;
      for (const std::uint32_t operand : cell.operands) winding += windings_[operand];
      if (rule == Rule::positive ? winding > 0 : rule == Rule::nonzero ? winding != 0 : winding % 2)
        material.push_back(cell.solid);
    }
    return unite(material);
  }

 private:
  double real(int low, int high) {
    return low + static_cast<int>(random_() % static_cast<unsigned>(high - low + 1));
  }

  // A block with an edge on the z-axis, with the axis in a face, or within.
  void add_beside_axis() {
    const double x = random_() % 2 == 0 ? 0 : real(-9, -1),
                 y = random_() % 2 == 0 ? 0 : real(-9, -1), low = real(0, 39),
                 high = low + real(1, 40), width = real(1, 30);
    add(block({x, y, low}, {width, width, high}).to_mesh(), random_() % 2 == 0);
  }

  // If it is a solid; inside out or not.
  void add(const PolygonMesh& part, bool inside_out) {
    if (part.face_sizes.empty() || !is_accepted(part)) return;
    solids_.push_back(Solid::from_mesh(part));
    windings_.push_back(inside_out ? -1 : 1);
    append(inside_out ? turned(part) : part, mesh_);
  }

  std::mt19937 random_;
  std::vector<Solid> solids_;
  std::vector<int> windings_;
  PolygonMesh mesh_;
};

void expect_what_cells_are(const KindOfCrowd& kind, unsigned first_seed, unsigned count,
                           int parts) {
  for (unsigned seed = first_seed; seed < first_seed + count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const CrowdInOneMesh crowd(seed, kind, parts);
    for (const Rule rule : {Rule::positive, Rule::nonzero, Rule::odd}) {
      const Solid solid = crowd.repaired(rule);
      EXPECT_EQ(solid, crowd.wanted(rule));
      EXPECT_TRUE(validate(solid).empty());
    }
    if (testing::Test::HasFailure()) return;
  }
}

class RepairedCrowds : public testing::TestWithParam<KindOfCrowd> {};
class RepairedCrowdsExhaustive : public RepairedCrowds {};

TEST_P(RepairedCrowds, AreWhatTheCellsOfTheirPartsSay) {
  expect_what_cells_are(GetParam(), 1, cases(6u), 8);
}

TEST_P(RepairedCrowdsExhaustive, AreWhatTheCellsOfTheirPartsSay) {
  expect_what_cells_are(GetParam(), 100, 12, 60);
}

std::string name_of(const testing::TestParamInfo<KindOfCrowd>& kind) {
  return kind.param.name;
}

INSTANTIATE_TEST_SUITE_P(All, RepairedCrowds, testing::ValuesIn(kinds_of_crowds()), name_of);
INSTANTIATE_TEST_SUITE_P(All, RepairedCrowdsExhaustive, testing::ValuesIn(kinds_of_crowds()),
                         name_of);

}  // namespace
}  // namespace sectile::test
