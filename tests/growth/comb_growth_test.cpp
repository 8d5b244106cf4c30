// Booleans, cells, repair and validation of combs with n teeth: all boxes of slanted teeth overlap,
// and a line along the comb meets every tooth.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "growth/steps.h"
#include "sectile/arrangement.h"
#include "sectile/boolean.h"
#include "sectile/primitives.h"
#include "sectile/rounding.h"
#include "sectile/transform.h"
#include "sectile/validate.h"

namespace sectile {
namespace {

using Shape = Solid (*)(std::size_t n);

// add_tooth(x, length, outline) adds the tooth that begins at x, from its right end to its left
// one.
template <class AddTooth>
Solid comb(std::size_t n, const AddTooth& add_tooth) {
  const auto length = static_cast<double>(n);
  Profile comb;
  comb.outer = {{-1, -1}, {length + 1, -1}};
  for (std::size_t i = n; i-- > 0;) add_tooth(static_cast<double>(i), length, comb.outer);
  return extrude(comb, 1);
}

Solid upright(std::size_t n) {
  return comb(n, [](double x, double length, std::vector<Vec2>& outline) {
    outline.insert(outline.end(),
                   {{x + 0.75, 0}, {x + 0.75, length}, {x + 0.25, length}, {x + 0.25, 0}});
  });
}

Solid slanted(std::size_t n) {
  return comb(n, [](double x, double length, std::vector<Vec2>& outline) {
    outline.insert(outline.end(), {{x + 0.75, 0}, {x + length + 0.5, length}, {x + 0.25, 0}});
  });
}

Solid star(std::size_t n) {
  Profile star;
  for (std::size_t i = 0; i < 2 * n; ++i) {
    const double angle = std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    const double radius = static_cast<double>(n) * (i % 2 == 0 ? 1 : 0.5);
    star.outer.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return extrude(star, 1);
}

Solid moved(const Solid& solid, const Vec3& by) {
  return transformed(solid, Transform::translation(by));
}

struct NamedShape {
  const char* name;
  Shape shape;
};
void PrintTo(const NamedShape& s, std::ostream* out) {
  *out << s.name;
}

class CombGrowth : public testing::TestWithParam<NamedShape> {
 protected:
  // Of what is done with a comb and the same one moved.
  template <class Work>
  static double growth_with(const Vec3& by, const Work& work, std::size_t n = 150) {
    return growth(
        [&](std::size_t size) {
          const Solid a = GetParam().shape(size), b = moved(a, by);
          return [a, b, work] { work(a, b); };
        },
        n);
  }
};

constexpr Vec3 across{0.125, 0.0625, 0.25}, in_plane{0.125, 0.0625, 0}, on_top{0.125, 0.0625, 1};

void subtract(const Solid& a, const Solid& b) {
  boolean(a, b, Operation::subtract);
}
void find_cells(const Solid& a, const Solid& b) {
  const std::array<Solid, 2> both{a, b};
  cells(both);
}

TEST_P(CombGrowth, OneInAnother) {
  EXPECT_LT(growth_with(across, subtract), n_log_n);
}
TEST_P(CombGrowth, OneFlushWithAnother) {
  EXPECT_LT(growth_with(in_plane, subtract), n_log_n);
}
TEST_P(CombGrowth, OneOnTopOfAnother) {
  EXPECT_LT(growth_with(on_top, subtract), n_log_n);
}
TEST_P(CombGrowth, CellsOfOneInAnother) {
  EXPECT_LT(growth_with(across, find_cells), n_log_n);
}
TEST_P(CombGrowth, CellsOfOneFlushWithAnother) {
  EXPECT_LT(growth_with(in_plane, find_cells), n_log_n);
}

TEST_P(CombGrowth, ValidationOfWhatIsLeftOfOne) {
  EXPECT_LT(growth(
                [](std::size_t n) {
                  const Solid comb = GetParam().shape(n);
                  const double size = 4 * static_cast<double>(n);
                  const Solid left = boolean(comb, block({-size, -size, 0.25}, {size, size, 2}),
                                             Operation::subtract);
                  return [left] { validate(left); };
                },
                150),
            1.35);
}
// Of slanted teeth, pieces are left, whose boxes hold each other.
TEST_P(CombGrowth, WritingWhatIsLeftOfOneThatIsCut) {
  const auto work = [](std::size_t n) {
    const double size = static_cast<double>(n);
    const Solid tool = transformed(block({-2 * size, 0.3 * size, -1}, {3 * size, 2 * size, 2}),
                                   Transform::rotation_degrees({0.1, 0.2, 1}, 1));
    const Solid left = boolean(GetParam().shape(n), tool, Operation::subtract);
    return [left] { rounded_mesh(left); };
  };
  EXPECT_LT(growth(work, GetParam().shape == star ? 1200 : 300), n_log_n);
}

// Below the teeth, slivers of both reach through all of the comb: their boxes overlap.
TEST_P(CombGrowth, RepairOfOneFlushWithAnother) {
  EXPECT_LT(
      growth(
          [](std::size_t n) {
            const Solid a = GetParam().shape(n);
            PolygonMesh both = a.to_mesh();
            const PolygonMesh b = moved(a, in_plane).to_mesh();
            const auto first = static_cast<std::uint32_t>(both.positions.size());
            both.positions.insert(both.positions.end(), b.positions.begin(), b.positions.end());
            for (const std::uint32_t i : b.indices) both.indices.push_back(first + i);
            both.face_sizes.insert(both.face_sizes.end(), b.face_sizes.begin(), b.face_sizes.end());
            return [both] {
              ImportOptions options;
              options.resolve = Rule::positive;
              Solid::from_mesh(both, options);
            };
          },
          100),
      1.7);
}

INSTANTIATE_TEST_SUITE_P(, CombGrowth,
                         testing::Values(NamedShape{"Upright", upright},
                                         NamedShape{"Slanted", slanted}, NamedShape{"Star", star}),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace sectile
