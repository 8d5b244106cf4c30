// Solids that have many faces in common, as two versions of a part have: what is the same in both
// is left out, and nothing of the result is another for it.
#include "boolean/near/common_faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "boolean/near/slot_pairs.h"
#include "boolean/workspace.h"
#include "cases.h"
#include "sectile/sectile.h"

namespace sectile {
namespace {

using Change = std::function<Vec3(const Vec3&)>;

PolygonMesh changed(PolygonMesh mesh, const Change& change) {
  for (Vec3& p : mesh.positions) p = change(p);
  return mesh;
}

// What is within a ball is pushed down, most in its middle.
Change dent(const Vec3& middle, double radius, double depth = 0.3) {
  return [=](const Vec3& p) {
    const double far = std::hypot(p.x - middle.x, p.y - middle.y, p.z - middle.z);
    return far < radius ? Vec3{p.x, p.y, p.z - (radius - far) * depth} : p;
  };
}

// Under the sanitizers blocks are small, so that small parts will do.
constexpr std::uint32_t rings = 4 + cases(20u), segments = 2 * rings - 8;

const PolygonMesh& ball_mesh() {
  static const PolygonMesh mesh = sphere_mesh({0, 0, 0}, 1, segments, rings);
  return mesh;
}
const Solid& ball() {
  static const Solid solid = Solid::from_mesh(ball_mesh());
  return solid;
}
Solid dented_ball(const Vec3& middle = {0, 0, 1}, double radius = 0.3) {
  return Solid::from_mesh(changed(ball_mesh(), dent(middle, radius)));
}

CommonFaces common_faces(const Solid& a, const Solid& b) {
  const BooleanOptions options;
  const Workspace w(options);
  const SlotPairs slots(*a.data(), *b.data());
  return CommonFaces(w, *a.data(), *b.data(), slots.slots());
}

template <class Visit>
void for_each_face(const Solid& solid, const Visit& visit) {
  const SolidData& data = *solid.data();
  for (std::uint32_t s = 0; s < data.slots().size(); ++s)
    for (std::uint32_t f = 0; f < data.slot(s).faces; ++f) visit(s, FaceId(f));
}

std::vector<Vec3> corners(const Solid& solid, std::uint32_t s, FaceId f) {
  const Block& block = *solid.data()->slot(s).block;
  std::vector<Vec3> corners;
  for_each_in_face(block.brep(), f, [&](HalfEdgeId h) {
    corners.push_back(block.geometry().position(block.brep().point_of(block.brep().from(h))));
  });
  return corners;
}

TEST(CommonFaces, AreDeepWhereNothingAroundTheirCornersIsChanged) {
  const double radius = 0.3;
  const Solid dented = dented_ball({0, 0, 1}, radius);
  const CommonFaces found = common_faces(ball(), dented);
  // The corners of faces of which a corner is changed.
  std::vector<Vec3> at_changes;
  const auto is_changed = [&](const Vec3& p) { return std::hypot(p.x, p.y, p.z - 1) < radius; };
  for_each_face(ball(), [&](std::uint32_t s, FaceId f) {
    const std::vector<Vec3> of_face = corners(ball(), s, f);
    if (std::ranges::any_of(of_face, is_changed))
      at_changes.insert(at_changes.end(), of_face.begin(), of_face.end());
  });
  std::size_t deep = 0;
  for_each_face(ball(), [&](std::uint32_t s, FaceId f) {
    const bool is_at_change = std::ranges::any_of(corners(ball(), s, f), [&](const Vec3& p) {
      return std::ranges::find(at_changes, p) != at_changes.end();
    });
    const bool is_deep = found.has(Operand::a, s, f);
    EXPECT_FALSE(is_at_change && is_deep);
    if (!is_deep) return;
    ++deep;
    EXPECT_EQ(found.class_of(Operand::a, s, f), Class::on_plus);
  });
  std::size_t deep_in_b = 0;
  for_each_face(
      dented, [&](std::uint32_t s, FaceId f) { deep_in_b += found.has(Operand::b, s, f) ? 1 : 0; });
  EXPECT_EQ(deep, deep_in_b);
  EXPECT_GT(deep, ball().counts().faces / 2);  // there are most faces near the poles
}

TEST(CommonFaces, RunTheOtherWayAroundInAMould) {
  const Solid mould = boolean(block({-2, -2, -2}, {2, 2, 2}), ball(), Operation::subtract);
  const CommonFaces found = common_faces(mould, ball());
  std::size_t deep = 0;
  for_each_face(ball(), [&](std::uint32_t s, FaceId f) {
    if (!found.has(Operand::b, s, f)) return;
    ++deep;
    EXPECT_EQ(found.class_of(Operand::b, s, f), Class::on_minus);
  });
  EXPECT_EQ(deep, ball().counts().faces);
}

TEST(CommonFaces, AreThoseOfAllSlotsWhereBothAreTheSame) {
  const CommonFaces found = common_faces(ball(), Solid::from_mesh(ball_mesh()));
  for (const Operand s : both_operands)
    for (std::uint32_t i = 0; i < ball().data()->slots().size(); ++i)
      EXPECT_TRUE(found.has_all(s, i));
}

TEST(CommonFaces, AreNoneOfSolidsThatOnlyCross) {
  EXPECT_TRUE(common_faces(ball(), Solid::from_mesh(changed(ball_mesh(),
                                                            [](const Vec3& p) {
                                                              return Vec3{p.x + 0x1p-50, p.y, p.z};
                                                            })))
                  .empty());
}

// Nothing is left out where somebody follows the phases.
Solid with_all_pairs(const Solid& a, const Solid& b, Operation operation) {
  struct Watch : Observer {
    void phase_done(Phase, const std::vector<TraceEvent>&) override {}
  } watch;
  BooleanOptions options;
  options.observer = &watch;
  return boolean(a, b, operation, options);
}

void expect_same_results(const Solid& a, const Solid& b) {
  EXPECT_FALSE(common_faces(a, b).empty());
  for (const Operation operation : {Operation::unite, Operation::intersect, Operation::subtract})
    for (int order = 0; order < cases(2); ++order) {
      const Solid &first = order == 0 ? a : b, &second = order == 0 ? b : a;
      const Solid result = boolean(first, second, operation),
                  expected = with_all_pairs(first, second, operation);
      EXPECT_TRUE(result == expected) << "operation " << static_cast<int>(operation);
      EXPECT_EQ(result.counts().faces, expected.counts().faces);
      EXPECT_EQ(result.counts().shells, expected.counts().shells);
      EXPECT_EQ(result.volume(), expected.volume());
      EXPECT_TRUE(validate(result).empty());
    }
}

TEST(VersionsOfAPart, WithADent) {
  expect_same_results(ball(), dented_ball());
}

TEST(VersionsOfAPart, WithDentsAnywhere) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anywhere(-1, 1), wide(0.05, 0.8), deep(-0.4, 0.4);
  for (int i = 0; i < cases(6); ++i) {
    PolygonMesh one = ball_mesh(), other = ball_mesh();
    for (int k = 0; k < 3; ++k) {
      const Vec3 p{anywhere(random), anywhere(random), anywhere(random)};
      PolygonMesh& mesh = k == 0 ? one : other;
      mesh = changed(mesh, dent(p, wide(random), deep(random)));
    }
    expect_same_results(Solid::from_mesh(one), Solid::from_mesh(other));
  }
}

TEST(VersionsOfAPart, FromWhichSomethingWasCut) {
  const Solid tool = sphere(0.4, 30, 20);
  const Solid cut = boolean(ball(), transformed(tool, Transform::translation({0.1, 0.2, 1})),
                            Operation::subtract),
              grown = boolean(ball(), transformed(tool, Transform::translation({-0.9, 0, 0.1})),
                              Operation::unite);
  expect_same_results(ball(), cut);
  expect_same_results(cut, grown);
  expect_same_results(boolean(ball(), tool, Operation::subtract), ball());  // a hollow
}

TEST(VersionsOfAPart, ThatWereMovedAlike) {
  const Transform move = Transform::rotation_degrees({1, 2, 3}, 31);
  expect_same_results(transformed(ball(), move), transformed(dented_ball({0, 0, 1}, 0.6), move));
}

TEST(VersionsOfAPart, MouldAndCast) {
  const Solid mould = boolean(block({-2, -2, -2}, {2, 2, 2}), ball(), Operation::subtract);
  expect_same_results(mould, ball());
  expect_same_results(mould, dented_ball());
}

TEST(VersionsOfAPart, WithAndWithoutAWholeShell) {
  const Solid second =
                  transformed(sphere(1, segments, rings), Transform::translation({0.5, 2.5, 0})),
              both = boolean(ball(), second, Operation::unite);
  expect_same_results(both, ball());
  expect_same_results(both, boolean(both, sphere(1.2, 20, 10), Operation::subtract));
  expect_same_results(both, boolean(second, dented_ball(), Operation::unite));
}

// A ball that stands on a block on its lowest corner, a roll that lies on it on an edge: nothing in
// their structure says so.
TEST(VersionsOfAPart, ThatTouchTheirOtherPartsInAPointOrALine) {
  const Solid table = block({-3, -3, -2}, {3, 3, -1}),
              small_table = block({-0.05, -3, -2}, {3, 0.1, -1}),
              roll = transformed(cylinder(1, 2, 25 * rings),
                                 Transform::rotation_degrees({0, 1, 0}, 90));
  for (const Solid& part : {ball(), roll}) {
    const Solid on_table = boolean(part, table, Operation::unite),
                on_small_table = boolean(part, small_table, Operation::unite);
    expect_same_results(on_table, part);
    expect_same_results(on_table, on_small_table);
    const Solid cut =
        boolean(on_table, block({0.2, -0.3, 0.5}, {0.6, 0.3, 2}), Operation::subtract);
    expect_same_results(cut, on_small_table);
    expect_same_results(cut, on_table);
  }
}

// Spikes of each version stand with their tips on one face that both have: none of its corners is
// there, and what a spike is to the other version cannot be told from its tip.
TEST(VersionsOfAPart, OnWhoseFaceDifferentSpikesStand) {
  const double turn = 2 * std::numbers::pi / (50 * rings);
  Profile profile;
  for (std::uint32_t i = 0; i < 50 * rings; ++i)
    profile.outer.push_back({10 * std::cos(i * turn), 10 * std::sin(i * turn)});
  const Solid part = extrude(profile, 1);
  const auto with_spikes = [&](double first) {
    std::vector<Solid> all{part};
    for (int i = 0; i < 12; ++i) {
      const double x = first + 0.5 * i;
      PolygonMesh spike{{{x, 0, 1}, {x, 0.25, 2}, {x - 0.125, 0, 2}, {x + 0.125, 0, 2}},
                        {3, 3, 3, 3},
                        {0, 1, 3, 0, 2, 1, 0, 3, 2, 1, 2, 3}};
      all.push_back(Solid::from_mesh(spike));
    }
    return unite(all);
  };
  expect_same_results(with_spikes(-3), with_spikes(-2.75));
  expect_same_results(with_spikes(-3), part);
}

// Their corners are in one place, and the structure says so.
TEST(VersionsOfAPart, OfBallsThatTouchInTheirPoles) {
  const Solid above = transformed(ball(), Transform::translation({0, 0, 2})),
              both = boolean(ball(), above, Operation::unite);
  expect_same_results(both, ball());
  expect_same_results(both, above);
  expect_same_results(both,
                      boolean(both, block({0.2, -0.1, -2}, {2, 0.1, 3}), Operation::subtract));
}

// One face has all their rims as holes.
TEST(VersionsOfAPart, PlatesWithManyPocketsOfWhichSomeAreFilledUpToBelowTheRim) {
  constexpr int count = (rings + 4) / 2;
  Profile profile{{{0, 0}, {count, 0}, {count, count}, {0, count}}, {}};
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j) {
      std::vector<Vec2> hole;
      for (int k = 0; k < 6; ++k)
        hole.push_back({i + 0.5 + 0.3 * std::cos(k * 1.05), j + 0.5 + 0.3 * std::sin(k * 1.05)});
      profile.holes.push_back(hole);
    }
  const Solid plate = boolean(extrude(profile, 1), block({0, 0, -1}, {count, count, 0}),
                              Operation::unite),
              some = boolean(plate, block({3, 3, 0}, {5.2, 8.4, 0.5}), Operation::unite),
              others = boolean(plate, block({4, 7, -0.5}, {9, 9, 0.25}), Operation::unite);
  expect_same_results(plate, some);
  expect_same_results(some, others);
}

TEST(VersionsOfAPart, AreFoundBySampling) {
  const auto seem_common = [](const Solid& a, const Solid& b) {
    const SlotPairs slots(*a.data(), *b.data());
    return seem_to_have_common_faces(*a.data(), *b.data(), slots.slots());
  };
  EXPECT_TRUE(seem_common(ball(), dented_ball({0, 0, 1}, 1.5)));
  EXPECT_FALSE(seem_common(ball(), transformed(ball(), Transform::rotation_degrees({1, 2, 3}, 1))));
}

}  // namespace
}  // namespace sectile
