// Random chains of everything: results and their images go on as operands, and the laws that bind
// operations to each other hold exactly at each step.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <vector>

#include "cases.h"
#include "operations.h"
#include "random_shapes.h"
#include "unit/exact_mesh_checker.h"
#include "unit/same_shape.h"

namespace sectile::test {
namespace {

struct Results {
  Results(const Solid& a, const Solid& b)
      : x(a),
        y(b),
        all(test::unite(a, b)),
        common(meet(a, b)),
        x_alone(minus(a, b)),
        y_alone(minus(b, a)) {}
  const Solid& of(Operation operation) const {
    return operation == Operation::unite       ? all
           : operation == Operation::intersect ? common
                                               : x_alone;
  }
  Solid x, y, all, common, x_alone, y_alone;
};

// Volumes and areas are rounded, each by itself.
void expect_sum(double a, double b, double scale) {
  EXPECT_NEAR(a, b, 1e-12 * scale);
}

void expect_same_counts(const Solid& a, const Solid& b) {
  const SolidCounts p = a.counts(), q = b.counts();
  EXPECT_EQ(p.vertices, q.vertices);
  EXPECT_EQ(p.faces, q.faces);
  EXPECT_EQ(p.shells, q.shells);
  EXPECT_EQ(p.genus, q.genus);
}

void expect_laws_of_sets(const Results& r) {
  for (const Solid* solid : {&r.all, &r.common, &r.x_alone, &r.y_alone})
    EXPECT_TRUE(validate(*solid).empty());
  EXPECT_EQ(unite(r.x_alone, r.common), r.x);
  EXPECT_EQ(unite(unite(r.x_alone, r.y_alone), r.common), r.all);
  EXPECT_EQ(minus(r.all, r.y), r.x_alone);
  EXPECT_EQ(minus(r.all, r.x_alone), r.y);
  EXPECT_EQ(unite(r.x_alone, r.y), r.all);
  EXPECT_TRUE(meet(r.x_alone, r.y).is_empty());
  const double x = r.x.volume(), y = r.y.volume();
  expect_sum(r.all.volume() + r.common.volume(), x + y, x + y);
  expect_sum(r.x_alone.volume() + r.common.volume(), x, x + y);
}

void expect_images_of_results(const Results& r, const Transform& map) {
  const Solid x = transformed(r.x, map), y = transformed(r.y, map);
  EXPECT_TRUE(validate(x).empty());
  for (const Operation operation : all_operations) {
    const Solid image = transformed(r.of(operation), map), made = boolean(x, y, operation);
    EXPECT_EQ(image, made);
    expect_same_counts(image, made);
  }
  const auto inverse = ExactTransform(map).inverse();
  if (inverse) {
    EXPECT_EQ(transformed(x, *inverse), r.x);
  }
}

void expect_halves(const Solid& x, const HalfSpace& half_space) {
  const auto [low, high] = split(x, half_space);
  EXPECT_TRUE(validate(low).empty());
  EXPECT_TRUE(validate(high).empty());
  EXPECT_EQ(unite(low, high), x);
  EXPECT_TRUE(meet(low, high).is_empty());
}

void expect_cells(const Results& r, const Solid& z) {
  const std::array<Solid, 3> all{r.x, r.y, z};
  EXPECT_EQ(sectile::unite(all), unite(r.all, z));
  EXPECT_EQ(sectile::intersect(all), meet(r.common, z));
  Solid sum;
  for (const SolidCell& cell : cells(all)) {
    Solid expected = all[cell.operands[0]];
    for (std::uint32_t k = 0; k < all.size(); ++k) {
      const bool covers =
          std::find(cell.operands.begin(), cell.operands.end(), k) != cell.operands.end();
      expected = boolean(expected, all[k], covers ? Operation::intersect : Operation::subtract);
    }
    EXPECT_EQ(cell.solid, expected);
    EXPECT_TRUE(validate(cell.solid).empty());
    sum = unite(sum, cell.solid);
  }
  EXPECT_EQ(sum, unite(r.all, z));
}

// Of which parts the results are made (paper, section 3).
void expect_parts(const Results& r) {
  const EightWay w = classify(r.x, r.y);
  const double x = r.x.area(), y = r.y.area(), scale = x + y;
  expect_sum(w.a_in_b.area + w.a_out_b.area + w.a_on_b_plus.area + w.a_on_b_minus.area, x, scale);
  expect_sum(w.b_in_a.area + w.b_out_a.area + w.b_on_a_plus.area + w.b_on_a_minus.area, y, scale);
  expect_sum(w.a_out_b.area + w.b_out_a.area + w.a_on_b_plus.area, r.all.area(), scale);
  expect_sum(w.a_in_b.area + w.b_in_a.area + w.a_on_b_plus.area, r.common.area(), scale);
  expect_sum(w.a_out_b.area + w.b_in_a.area + w.a_on_b_minus.area, r.x_alone.area(), scale);
}

void expect_written(const Solid& solid, const Rounding& rounding) {
  const RoundedMesh rounded = rounded_mesh(solid, rounding);
  EXPECT_EQ(ExactMeshChecker(rounded.mesh).verdict(), "");
  EXPECT_EQ(shape_fault(solid, rounded), "");
  if (rounded.mesh.positions.empty()) return;
  const Solid read = Solid::from_mesh(rounded.mesh);
  EXPECT_EQ(repair(rounded.mesh), read);
  if (rounded.report.moved == 0) {
    EXPECT_EQ(read, solid);
  }
}

void expect_kept_exactly(const Solid& solid) {
  std::stringstream file;
  write_exact(file, solid);
  EXPECT_EQ(read_exact(file, "solid"), solid);
}

// One solid of five is replaced at each step.
class Chain {
 public:
  explicit Chain(unsigned seed) : shapes_(seed) {
    for (int i = 0; i < 5; ++i) pool_.push_back(shapes_.shape());
  }

  void step() {
    const Solid x = any(), y = shapes_.number(0, 2) > 0 ? shapes_.shape() : any();
    const Results results(x, y);
    const Transform map = shapes_.map();
    expect_laws_of_sets(results);
    expect_images_of_results(results, map);
    expect_halves(x, shapes_.half_space());
    expect_parts(results);
    if (one_of(3)) expect_cells(results, shapes_.shape());
    const Operation operation = all_operations[shapes_.number(0, 2)];
    const Solid& result = results.of(operation);
    if (one_of(2)) expect_written(result, rounding());
    if (one_of(4)) expect_kept_exactly(result);
    put(one_of(4) ? transformed(result, map) : result);
  }

 private:
  bool one_of(int many) { return shapes_.number(1, many) == 1; }
  Solid& any() { return pool_[static_cast<std::size_t>(shapes_.number(0, 4))]; }
  void put(const Solid& result) {
    any() = result.is_empty() || result.counts().faces > 160 ? shapes_.shape() : result;
  }
  Rounding rounding() {
    Rounding rounding;
    rounding.numbers = static_cast<Rounding::Numbers>(shapes_.number(0, 2));
    rounding.spacing = std::ldexp(1.0, -shapes_.number(0, 12));
    return rounding;
  }

  RandomShapes shapes_;
  std::vector<Solid> pool_;
};

void expect_lawful_chains(unsigned first_seed, unsigned count) {
  for (unsigned seed = first_seed; seed < first_seed + count; ++seed) {
    Chain chain(seed);
    for (int step = 0; step < 25; ++step) {
      SCOPED_TRACE("seed " + std::to_string(seed) + " step " + std::to_string(step));
      chain.step();
      if (testing::Test::HasFailure()) return;
    }
  }
}

TEST(RandomChains, FourOfTwentyFiveSteps) {
  expect_lawful_chains(1, cases(4));
}

class RandomChainsExhaustive : public testing::TestWithParam<unsigned> {};

TEST_P(RandomChainsExhaustive, FortyOfTwentyFiveSteps) {
  expect_lawful_chains(1000 * (GetParam() + 1), 40);
}

INSTANTIATE_TEST_SUITE_P(Of, RandomChainsExhaustive, testing::Range(0u, 4u));

}  // namespace
}  // namespace sectile::test
