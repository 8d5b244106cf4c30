// Soups: overlapping boxes, tetrahedra and prisms of a lattice in one mesh, with shared vertices or
// their own, some of them inside out; and the same parts as solids, united all at once, in pairs,
// and as cells. All are sets of the 48 Kuhn tetrahedra of a 2×2×2 block, so that everything can be
// counted.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "boundary.h"
#include "cases.h"
#include "complex.h"
#include "fault.h"
#include "sectile/sectile.h"

namespace sectile::test {
namespace {

class Soups {
 public:
  explicit Soups(unsigned seed) : random_(seed), complex_(Complex::tetrahedra(2)) {}

  /// What is wrong with the next one; empty if nothing is.
  std::string next(bool as_solids) {
    parts_.clear();
    const std::size_t count = 2 + random_() % 11;
    for (std::size_t i = 0; i < count; ++i) parts_.push_back(random_part());
    if (std::string fault = fault_of_union(); !fault.empty()) return fault;
    if (std::string fault = fault_of_orientations(); !fault.empty()) return fault;
    return as_solids ? fault_of_solids() : std::string();
  }

 private:
  int below(unsigned end) { return static_cast<int>(random_() % end); }

  // The cells whose centre satisfies a condition.
  template <class Condition>
  Mask cells(const Condition& condition) const {
    Mask mask = 0;
    for (int c = 0; c < complex_.cell_count(); ++c) {
      const Vec3& p = complex_.cell(c).centre;
      if (condition(std::array<double, 3>{p.x, p.y, p.z})) mask |= Mask{1} << c;
    }
    return mask;
  }

  Mask random_part() {
    const int kind = below(3);
    const int size = kind == 0 ? 0 : 1 + below(2);
    std::array<int, 3> low, high;
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = below(size == 0 ? 2u : 3u - unsigned(size));
      high[k] = size == 0 ? low[k] + 1 + below(2u - unsigned(low[k])) : low[k] + size;
    }
    std::array<std::size_t, 3> axis{0, 1, 2};
    std::shuffle(axis.begin(), axis.end(), random_);
    return cells([&](const std::array<double, 3>& p) {
      for (std::size_t k = 0; k < 3; ++k)
        if (p[k] < low[k] || p[k] > high[k]) return false;
      const auto height = [&](std::size_t k) { return p[axis[k]] - low[axis[k]]; };
      // A box, a prism that is half of a cube, or a tetrahedron that is a sixth of one.
      if (kind > 0 && height(0) > height(1)) return false;
      return kind < 2 || height(1) <= height(2);
    });
  }

  // The parts' faces in one mesh; bit i of `inwards`: part i is inside out.
  PolygonMesh mesh(Mask inwards) {
    std::map<std::array<double, 3>, std::uint32_t> known;
    const bool shared = random_() % 2 == 0;
    PolygonMesh soup;
    std::vector<std::vector<std::uint32_t>> faces;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const Meshing how = all_meshings[random_() % std::size(all_meshings)];
      const PolygonMesh part = Boundary(complex_, parts_[i]).mesh(how);
      std::vector<std::uint32_t> vertex;
      for (const Vec3& p : part.positions) {
        const auto next = static_cast<std::uint32_t>(soup.positions.size());
        const auto [at, made] = known.try_emplace({p.x, p.y, p.z}, next);
        vertex.push_back(shared && !made ? at->second : next);
        if (vertex.back() == next) soup.positions.push_back(p);
      }
      std::size_t corner = 0;
      for (const std::uint32_t size : part.face_sizes) {
        faces.emplace_back();
        for (std::uint32_t k = 0; k < size; ++k)
          faces.back().push_back(vertex[part.indices[corner++]]);
        if ((inwards >> i & 1) != 0) std::reverse(faces.back().begin(), faces.back().end());
      }
    }
    std::shuffle(faces.begin(), faces.end(), random_);
    for (const auto& face : faces) {
      soup.face_sizes.push_back(static_cast<std::uint32_t>(face.size()));
      soup.indices.insert(soup.indices.end(), face.begin(), face.end());
    }
    return soup;
  }

  // The cells whose winding number is material.
  template <class Material>
  Mask wanted(Mask inwards, const Material& material) const {
    Mask result = 0;
    for (int c = 0; c < complex_.cell_count(); ++c) {
      int winding = 0;
      for (std::size_t i = 0; i < parts_.size(); ++i)
        if (Complex::has(parts_[i], c)) winding += (inwards >> i & 1) != 0 ? -1 : 1;
      if (material(winding)) result |= Mask{1} << c;
    }
    return result;
  }

  std::string named(const std::string& what, const std::string& fault) const {
    if (fault.empty()) return {};
    std::string text = what + ": " + fault + "; parts";
    for (const Mask part : parts_) text += " " + std::to_string(part);
    return text;
  }

  std::string fault_of_repair(Rule rule, Mask inwards, Mask cells) {
    RepairOptions options;
    options.rule = rule;
    return named("rule " + std::to_string(int(rule)) + " inwards " + std::to_string(inwards),
                 fault(repair(mesh(inwards), options), complex_, cells, true));
  }

  std::string fault_of_union() {
    return fault_of_repair(Rule::positive, 0, wanted(0, [](int w) { return w > 0; }));
  }

  std::string fault_of_orientations() {
    const Mask inwards = random_() & ((Mask{1} << parts_.size()) - 1);
    std::string fault =
        fault_of_repair(Rule::nonzero, inwards, wanted(inwards, [](int w) { return w != 0; }));
    if (!fault.empty()) return fault;
    return fault_of_repair(Rule::odd, inwards, wanted(inwards, [](int w) { return w % 2 != 0; }));
  }

  std::string fault_of_solids() {
    std::vector<Solid> solids;
    for (const Mask part : parts_)
      solids.push_back(Solid::from_mesh(Boundary(complex_, part).mesh(Meshing::merged)));
    const std::span<const Solid> all(solids);
    Mask united = 0, common = complex_.all(), others = 0;
    Solid pairwise, common_pairwise = solids[0], rest_pairwise = solids[0];
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      united |= parts_[i];
      common &= parts_[i];
      if (i > 0) others |= parts_[i];
      pairwise = boolean(pairwise, solids[i], Operation::unite);
      common_pairwise = boolean(common_pairwise, solids[i], Operation::intersect);
      if (i > 0) rest_pairwise = boolean(rest_pairwise, solids[i], Operation::subtract);
    }
    struct Case {
      const char* name;
      Solid solid;
      const Solid& other;
      Mask cells;
    };
    for (const Case& c : {Case{"unite", unite(all), pairwise, united},
                          Case{"intersect", intersect(all), common_pairwise, common},
                          Case{"subtract", subtract(solids[0], all.subspan(1)), rest_pairwise,
                               parts_[0] & ~others}}) {
      if (std::string what = named(c.name, fault(c.solid, complex_, c.cells, true)); !what.empty())
        return what;
      if (!(c.solid == c.other)) return named(c.name, "is not what pairs give");
    }
    return fault_of_cells(all);
  }

  std::string fault_of_cells(std::span<const Solid> all) {
    std::map<std::vector<std::uint32_t>, Mask> wanted;
    for (int c = 0; c < complex_.cell_count(); ++c) {
      std::vector<std::uint32_t> operands;
      for (std::uint32_t i = 0; i < parts_.size(); ++i)
        if (Complex::has(parts_[i], c)) operands.push_back(i);
      if (!operands.empty()) wanted[operands] |= Mask{1} << c;
    }
    const std::vector<SolidCell> found = sectile::cells(all);
    if (found.size() != wanted.size()) return named("cells", "their number is wrong");
    auto at = wanted.begin();
    for (const SolidCell& cell : found) {
      if (cell.operands != at->first) return named("cells", "of the wrong operands");
      if (std::string what = named("cells", fault(cell.solid, complex_, at->second, true));
          !what.empty())
        return what;
      ++at;
    }
    return {};
  }

  std::mt19937_64 random_;
  Complex complex_;
  std::vector<Mask> parts_;
};

void expect_faultless(unsigned seed, int count, int solids_each) {
  Soups soups(seed);
  for (int i = 0; i < count; ++i)
    ASSERT_EQ(soups.next(i % solids_each == 0), "") << "seed " << seed << " soup " << i;
}

TEST(Soups, AHundredAgainstCountedCells) {
  expect_faultless(1, cases(100), 3);
}

// The union touches itself in an edge that lies in one of its faces. Where it is in several blocks,
// its two vertices at an end of that edge have points of their own.
TEST(Soups, ADifferenceWithAUnionThatTouchesItself) {
  const Complex complex = Complex::tetrahedra(2);
  const auto solid = [&](Mask cells) {
    return Solid::from_mesh(Boundary(complex, cells).mesh(Meshing::merged));
  };
  const Mask body = 12901681170, parts[] = {246505436938296, 2048, 274877906952};
  Solid all;
  Mask cells = 0;
  for (const Mask part : parts) {
    all = boolean(all, solid(part), Operation::unite);
    cells |= part;
  }
  EXPECT_EQ(fault(boolean(solid(body), all, Operation::subtract), complex, body & ~cells, true),
            "");
}

class SoupsExhaustive : public testing::TestWithParam<unsigned> {};

TEST_P(SoupsExhaustive, TwoThousandAgainstCountedCells) {
  expect_faultless(100 + GetParam(), 2000, 1);
}

INSTANTIATE_TEST_SUITE_P(Of, SoupsExhaustive, testing::Range(0u, 10u));

}  // namespace
}  // namespace sectile::test
