// What repair does to one thing that is wrong at a time, and what it says about it.
#include <gtest/gtest.h>

#include <atomic>
#include <random>

#include "sectile/sectile.h"

namespace sectile {
namespace {

using Kind = RepairChange::Kind;
using Face = std::vector<std::uint32_t>;

class Builder {
 public:
  Builder& box(const Vec3& low, const Vec3& high, bool turned = false) {
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    for (unsigned i = 0; i < 8; ++i)
      mesh_.positions.push_back(
          {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
    for (Face f : {Face{0, 2, 3, 1}, Face{4, 5, 7, 6}, Face{0, 1, 5, 4}, Face{2, 6, 7, 3},
                   Face{0, 4, 6, 2}, Face{1, 3, 7, 5}}) {
      if (turned) std::reverse(f.begin(), f.end());
      for (std::uint32_t& v : f) v += first;
      face(f);
    }
    return *this;
  }
  Builder& face(const Face& f) {
    mesh_.face_sizes.push_back(static_cast<std::uint32_t>(f.size()));
    mesh_.indices.insert(mesh_.indices.end(), f.begin(), f.end());
    return *this;
  }
  Builder& point(const Vec3& p) {
    mesh_.positions.push_back(p);
    return *this;
  }
  PolygonMesh mesh() const { return mesh_; }

 private:
  PolygonMesh mesh_;
};

PolygonMesh without_face(PolygonMesh mesh, std::size_t f) {
  std::size_t first = 0;
  for (std::size_t i = 0; i < f; ++i) first += mesh.face_sizes[i];
  const auto at = mesh.indices.begin() + static_cast<std::ptrdiff_t>(first);
  mesh.indices.erase(at, at + mesh.face_sizes[f]);
  mesh.face_sizes.erase(mesh.face_sizes.begin() + static_cast<std::ptrdiff_t>(f));
  return mesh;
}

PolygonMesh with_turned_face(PolygonMesh mesh, std::size_t f) {
  std::size_t first = 0;
  for (std::size_t i = 0; i < f; ++i) first += mesh.face_sizes[i];
  const auto at = mesh.indices.begin() + static_cast<std::ptrdiff_t>(first);
  std::reverse(at, at + mesh.face_sizes[f]);
  return mesh;
}

std::size_t count(const RepairReport& report, Kind kind) {
  std::size_t sum = 0;
  for (const RepairChange& change : report.changes)
    if (change.kind == kind) sum += change.count;
  return sum;
}

struct Repaired {
  Solid solid;
  RepairReport report;
};

Repaired repaired(const PolygonMesh& mesh, const RepairOptions& options = {}) {
  Repaired r;
  r.solid = repair(mesh, options, &r.report);
  EXPECT_TRUE(validate(r.solid).empty());
  return r;
}

TEST(RepairCases, ALegalMeshIsTakenAsItIs) {
  const PolygonMesh mesh = Builder().box({0, 0, 0}, {1, 1, 1}).mesh();
  const Repaired r = repaired(mesh);
  EXPECT_TRUE(r.report.changes.empty());
  EXPECT_EQ(r.solid.counts().faces, 6u);
  EXPECT_TRUE(r.solid == Solid::from_mesh(mesh));
  EXPECT_NE(r.solid.origin(), 0u);
}

TEST(RepairCases, TwoCubesThatOverlapInAnyOrder) {
  const PolygonMesh mesh =
      Builder().box({0, 0, 0}, {1, 1, 1}).box({0.5, 0.5, 0.5}, {2, 2, 2}).mesh();
  std::mt19937 random(3);
  for (int round = 0; round < 16; ++round) {
    PolygonMesh turned = mesh;
    for (std::size_t f = 0; f < 12; ++f)
      std::rotate(turned.indices.begin() + long(4 * f),
                  turned.indices.begin() + long(4 * f + random() % 4),
                  turned.indices.begin() + long(4 * f + 4));
    const Repaired r = repaired(turned);
    EXPECT_EQ(r.solid.volume(), 1 + 3.375 - 0.125);
    EXPECT_EQ(count(r.report, Kind::divided_faces), 6u);
    EXPECT_EQ(boolean(r.solid, block({0.6, 0.6, 0.6}, {0.9, 0.9, 0.9}), Operation::intersect)
                  .counts()
                  .faces,
              6u);
  }
}

TEST(RepairCases, InsideOutAsAWhole) {
  const Repaired r = repaired(Builder().box({0, 0, 0}, {1, 1, 1}, true).mesh());
  EXPECT_EQ(r.solid.volume(), 1);
  EXPECT_EQ(count(r.report, Kind::turned_parts), 1u);
}

TEST(RepairCases, InsideOutWithItsCavity) {
  const Repaired r =
      repaired(Builder().box({0, 0, 0}, {3, 3, 3}, true).box({1, 1, 1}, {2, 2, 2}, false).mesh());
  EXPECT_EQ(r.solid.volume(), 26);
  EXPECT_EQ(count(r.report, Kind::turned_parts), 1u);
}

TEST(RepairCases, OneOfTwoPartsInsideOut) {
  const Repaired r =
      repaired(Builder().box({0, 0, 0}, {1, 1, 1}, true).box({2, 0, 0}, {4, 1, 1}).mesh());
  EXPECT_EQ(r.solid.volume(), 3);
  EXPECT_EQ(count(r.report, Kind::turned_parts), 1u);
}

TEST(RepairCases, ACavityStays) {
  const Repaired r =
      repaired(Builder().box({0, 0, 0}, {3, 3, 3}).box({1, 1, 1}, {2, 2, 2}, true).mesh());
  EXPECT_EQ(r.solid.volume(), 26);
  EXPECT_TRUE(r.report.changes.empty());
}

TEST(RepairCases, AnInnerPartGoes) {
  const Repaired r = repaired(Builder().box({0, 0, 0}, {3, 3, 3}).box({1, 1, 1}, {2, 2, 2}).mesh());
  EXPECT_EQ(r.solid.volume(), 27);
  EXPECT_EQ(count(r.report, Kind::removed_faces), 6u);
}

TEST(RepairCases, FlushPartsBecomeOne) {
  const Repaired r = repaired(Builder().box({0, 0, 0}, {1, 1, 1}).box({1, 0, 0}, {2, 1, 1}).mesh());
  EXPECT_EQ(r.solid.volume(), 2);
  EXPECT_EQ(r.solid.area(), 10);
  EXPECT_EQ(count(r.report, Kind::overlaps), 1u);
}

PolygonMesh both(PolygonMesh a, const PolygonMesh& b) {
  const auto first = static_cast<std::uint32_t>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (const std::uint32_t i : b.indices) a.indices.push_back(first + i);
  a.face_sizes.insert(a.face_sizes.end(), b.face_sizes.begin(), b.face_sizes.end());
  return a;
}

// In triangles: the sides that lie on each other, and those in one plane, are faces as a whole.
TEST(RepairCases, FlushPartsOfTrianglesAreMadeOfWholeFaces) {
  const Solid a = block({0, 0, 0}, {2, 2, 2}), b = block({2, 1, 0}, {4, 3, 1});
  const Repaired r = repaired(both(a.to_mesh(), b.to_mesh()));
  const Solid united = boolean(a, b, Operation::unite);
  EXPECT_TRUE(r.solid == united);
  EXPECT_EQ(r.solid.counts().faces, united.counts().faces);
  EXPECT_GT(count(r.report, Kind::overlaps), 0u);
  EXPECT_GT(count(r.report, Kind::divided_faces), 0u);
  EXPECT_EQ(count(r.report, Kind::removed_faces), 0u);
}

TEST(RepairCases, APartInAnotherOneOfTrianglesIsReportedAsRemoved) {
  const Solid a = block({0, 0, 0}, {2, 2, 2}), b = block({1, 0.5, 0}, {3, 1, 1});
  const Repaired r = repaired(both(a.to_mesh(), b.to_mesh()));
  EXPECT_TRUE(r.solid == boolean(a, b, Operation::unite));
  EXPECT_EQ(count(r.report, Kind::removed_faces), 2u);  // two triangles at x = 1
}

TEST(RepairCases, FlatPartsOfALegalMeshAreFacesThatKnowTheirTriangles) {
  const Repaired r = repaired(block({0, 0, 0}, {1, 2, 3}).to_mesh());
  EXPECT_EQ(r.solid.counts().faces, 6u);
  EXPECT_EQ(r.solid.joined_faces(0).size(), 2u);
  EXPECT_EQ(r.solid.to_mesh().face_sizes.size(), 12u);
}

TEST(RepairCases, TheSamePartTwice) {
  const Repaired r = repaired(Builder().box({0, 0, 0}, {1, 1, 1}).box({0, 0, 0}, {1, 1, 1}).mesh());
  EXPECT_EQ(r.solid.volume(), 1);
  EXPECT_EQ(r.solid.counts().faces, 6u);
  EXPECT_EQ(count(r.report, Kind::overlaps), 6u);
  RepairOptions odd;
  odd.rule = Rule::odd;
  EXPECT_TRUE(repaired(Builder().box({0, 0, 0}, {1, 1, 1}).box({0, 0, 0}, {1, 1, 1}).mesh(), odd)
                  .solid.is_empty());
}

TEST(RepairCases, FacesThatContradictTheirNeighbours) {
  PolygonMesh mesh = Builder().box({0, 0, 0}, {1, 1, 1}).mesh();
  for (const std::size_t f : {1u, 4u}) mesh = with_turned_face(mesh, f);
  const Repaired r = repaired(mesh);
  EXPECT_EQ(r.solid.volume(), 1);
  EXPECT_EQ(count(r.report, Kind::turned_faces), 2u);
}

TEST(RepairCases, AFaceTwice) {
  for (const bool turned : {false, true}) {
    Builder builder;
    builder.box({0, 0, 0}, {1, 1, 1});
    builder.face(turned ? Face{1, 3, 2, 0} : Face{0, 2, 3, 1});
    const Repaired r = repaired(builder.mesh());
    EXPECT_EQ(r.solid.volume(), 1) << turned;
    EXPECT_EQ(count(r.report, Kind::removed_copies), 1u) << turned;
  }
}

TEST(RepairCases, TwoOppositeFacesBetweenNothing) {
  Builder builder;
  builder.box({0, 0, 0}, {1, 1, 1});
  builder.point({3, 0, 0}).point({4, 0, 0}).point({3, 1, 0});
  builder.face({8, 9, 10}).face({10, 9, 8});
  const Repaired r = repaired(builder.mesh());
  EXPECT_EQ(r.solid.volume(), 1);
  EXPECT_EQ(count(r.report, Kind::removed_faces), 2u);
}

TEST(RepairCases, CornersWithinEdges) {
  Builder builder;
  builder.box({0, 0, 0}, {1, 1, 1});
  PolygonMesh mesh = without_face(builder.mesh(), 1);  // the top, again in two halves
  mesh.positions.push_back({0.5, 0, 1});
  mesh.positions.push_back({0.5, 1, 1});
  for (const Face& f : {Face{4, 8, 9, 6}, Face{8, 5, 7, 9}}) {
    mesh.face_sizes.push_back(4);
    mesh.indices.insert(mesh.indices.end(), f.begin(), f.end());
  }
  const Repaired r = repaired(mesh);
  EXPECT_EQ(r.solid.volume(), 1);
  EXPECT_EQ(count(r.report, Kind::divided_edges), 2u);
}

TEST(RepairCases, HolesAreCountedAndClosedOnRequest) {
  const PolygonMesh mesh = without_face(
      without_face(Builder().box({0, 0, 0}, {1, 2, 3}).box({5, 0, 0}, {6, 1, 1}).mesh(), 7), 1);
  RepairReport report;
  try {
    repair(mesh, {}, &report);
    FAIL() << "holes were not refused";
  } catch (const InvalidSolid& error) {
    EXPECT_EQ(error.reason(), InvalidSolid::Reason::open);
    EXPECT_NE(std::string(error.what()).find("2 holes"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("length 6"), std::string::npos) << error.what();
  }
  ASSERT_EQ(report.holes.size(), 2u);
  EXPECT_EQ(report.holes[0].edges, 4u);
  EXPECT_EQ(report.holes[0].length, 6);
  EXPECT_EQ(report.holes[1].length, 4);
  RepairOptions options;
  options.close_holes = true;
  const Repaired r = repaired(mesh, options);
  EXPECT_EQ(r.solid.volume(), 7);
  EXPECT_EQ(count(r.report, Kind::closed_holes), 2u);
  EXPECT_EQ(r.report.holes.size(), 2u);
}

TEST(RepairCases, AHoleInNoPlane) {
  PolygonMesh mesh = without_face(Builder().box({0, 0, 0}, {1, 1, 1}).mesh(), 1);
  mesh.positions[7].z = 2;
  mesh.positions[4].z = 2;
  for (const Rule rule : {Rule::positive, Rule::nonzero, Rule::odd}) {
    RepairOptions options;
    options.rule = rule;
    options.close_holes = true;
    const Repaired r = repaired(mesh, options);
    EXPECT_GT(r.solid.volume(), 1);
    EXPECT_LT(r.solid.volume(), 2);
  }
}

TEST(RepairCases, BordersThatNearlyCoincide) {
  Builder builder;
  builder.box({0, 0, 0}, {1, 1, 1});
  PolygonMesh mesh = without_face(builder.mesh(), 1);
  const double off = 1e-7;
  mesh.positions.insert(mesh.positions.end(),
                        {{off, 0, 1}, {1, off, 1}, {0, 1 - off, 1}, {1 - off, 1, 1}});
  mesh.face_sizes.push_back(4);
  for (const std::uint32_t v : {8u, 9u, 11u, 10u}) mesh.indices.push_back(v);
  EXPECT_THROW(repair(mesh), InvalidSolid);
  RepairOptions options;
  options.stitch = 1e-6;
  const Repaired r = repaired(mesh, options);
  EXPECT_EQ(r.solid.volume(), 1);
  EXPECT_EQ(count(r.report, Kind::stitched_vertices), 4u);
  options.stitch = 1e-8;
  EXPECT_THROW(repair(mesh, options), InvalidSolid);
}

// A prism over a bow tie: two of its faces cross themselves, one side goes around the wrong way.
TEST(RepairCases, PolygonsThatCrossThemselves) {
  Builder builder;
  for (const double z : {0.0, 1.0})
    builder.point({0, 0, z}).point({2, 2, z}).point({2, 0, z}).point({0, 2, z});
  builder.face({3, 2, 1, 0}).face({4, 5, 6, 7});
  builder.face({0, 1, 5, 4}).face({1, 2, 6, 5}).face({2, 3, 7, 6}).face({3, 0, 4, 7});
  RepairOptions nonzero;
  nonzero.rule = Rule::nonzero;
  const Repaired r = repaired(builder.mesh(), nonzero);
  EXPECT_EQ(r.solid.volume(), 2);
  EXPECT_EQ(count(r.report, Kind::split_polygons), 2u);
  EXPECT_EQ(repaired(builder.mesh()).solid.volume(), 1);  // half of it goes around negatively
}

TEST(RepairCases, ManySheetsAtALine) {
  // Six wedges around the z axis, each a prism with edges of its own.
  Builder builder;
  const Vec3 around[] = {{2, 0, 0},   {1, 2, 0},  {-1, 2, 0}, {-2, 0, 0},
                         {-1, -2, 0}, {1, -2, 0}, {2, -1, 0}};
  double volume = 0;
  for (std::size_t k = 0; k < 6; ++k) {
    const Vec3 &p = around[k], &q = around[k + 1];
    const auto first = static_cast<std::uint32_t>(builder.mesh().positions.size());
    for (const double z : {0.0, 1.0})
      builder.point({0, 0, z}).point({p.x, p.y, z}).point({q.x, q.y, z});
    for (Face f :
         {Face{0, 2, 1}, Face{3, 4, 5}, Face{0, 1, 4, 3}, Face{1, 2, 5, 4}, Face{2, 0, 3, 5}}) {
      for (std::uint32_t& v : f) v += first;
      builder.face(f);
    }
    if (k < 5) volume += (p.x * q.y - p.y * q.x) / 2;
  }
  const Repaired r = repaired(builder.mesh());
  EXPECT_EQ(r.solid.volume(), volume + (1 * -1 - -2 * 2) / 2.0);
}

PolygonMesh side_by_side(PolygonMesh a, const PolygonMesh& b) {
  const auto first = static_cast<std::uint32_t>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  a.face_sizes.insert(a.face_sizes.end(), b.face_sizes.begin(), b.face_sizes.end());
  for (const std::uint32_t i : b.indices) a.indices.push_back(first + i);
  return a;
}

PolygonMesh turned(PolygonMesh mesh) {
  std::reverse(mesh.indices.begin(), mesh.indices.end());
  std::reverse(mesh.face_sizes.begin(), mesh.face_sizes.end());
  return mesh;
}

const RepairChange* change(const RepairReport& report, Kind kind) {
  for (const RepairChange& c : report.changes)
    if (c.kind == kind) return &c;
  return nullptr;
}

// In meshes of shells that are solids, whose Booleans know what is right.
class Shells : public testing::Test {
 protected:
  PolygonMesh a_ = sphere(1, 40, 20).to_mesh(),
              b_ = transformed(sphere(1, 40, 20), Transform::translation({0.5, 0.31, 0.13}))
                       .to_mesh();
  Solid first_ = Solid::from_mesh(a_), second_ = Solid::from_mesh(b_);
  RepairReport report_;

  Solid repaired(const PolygonMesh& mesh, Rule rule) {
    RepairOptions options;
    options.rule = rule;
    const Solid result = repair(mesh, options, &report_);
    EXPECT_TRUE(validate(result).empty());
    return result;
  }
};

TEST_F(Shells, ThatCrossAreUnited) {
  const PolygonMesh both = side_by_side(a_, b_);
  const Solid all = boolean(first_, second_, Operation::unite);
  for (const Rule rule : {Rule::positive, Rule::nonzero}) {
    const Solid result = repaired(both, rule);
    EXPECT_TRUE(result == all);
    ASSERT_EQ(report_.changes.size(), 2u);
    EXPECT_EQ(report_.changes[0].kind, Kind::divided_faces);
    EXPECT_EQ(report_.changes[1].kind, Kind::removed_faces);
    std::vector<FaceSource> sources;
    result.to_mesh(sources);
    std::vector<int> used(both.face_sizes.size(), 0);
    for (const FaceSource& source : sources) {
      EXPECT_EQ(source.solid, result.origin());
      used.at(source.face) = 1;
    }
    EXPECT_EQ(std::count(used.begin(), used.end(), 0), std::ptrdiff_t(report_.changes[1].count));
  }
}

TEST_F(Shells, CountOnceEachByTheRuleOdd) {
  const Solid result = repaired(side_by_side(a_, b_), Rule::odd);
  EXPECT_TRUE(result == boolean(boolean(first_, second_, Operation::unite),
                                boolean(first_, second_, Operation::intersect),
                                Operation::subtract));
}

TEST_F(Shells, OfWhichOneIsInsideOut) {
  const PolygonMesh both = side_by_side(a_, turned(b_));
  // They cross, so that neither is a part of its own.
  EXPECT_TRUE(repaired(both, Rule::positive) == boolean(first_, second_, Operation::subtract));
  EXPECT_EQ(change(report_, Kind::turned_parts), nullptr);
}

TEST_F(Shells, WithACavityThatAnotherOneReaches) {
  const Solid hollow = boolean(first_, transformed(first_, Transform::scaling({0.75, 0.75, 0.75})),
                               Operation::subtract);
  const PolygonMesh mesh = hollow.to_mesh();
  EXPECT_TRUE(repaired(side_by_side(mesh, b_), Rule::positive) ==
              boolean(Solid::from_mesh(mesh), second_, Operation::unite));
}

TEST_F(Shells, ThatLieInEachOtherAndApart) {
  PolygonMesh mesh = side_by_side(a_, b_);
  const PolygonMesh inner = block({-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}).to_mesh(),
                    apart = block({5, 5, 5}, {6, 6, 6}).to_mesh();
  mesh = side_by_side(side_by_side(mesh, inner), apart);
  const Solid all = boolean(boolean(first_, second_, Operation::unite), block({5, 5, 5}, {6, 6, 6}),
                            Operation::unite);
  EXPECT_TRUE(repaired(mesh, Rule::positive) == all);
}

TEST(RepairCases, OddNeedsNoOrientation) {
  PolygonMesh mesh = Builder().box({0, 0, 0}, {2, 2, 2}).box({1, 1, 1}, {3, 3, 3}).mesh();
  RepairOptions options;
  options.rule = Rule::odd;
  std::mt19937 random(5);
  for (int round = 0; round < 20; ++round) {
    PolygonMesh any = mesh;
    for (std::size_t f = 0; f < 12; ++f)
      if (random() % 2) any = with_turned_face(any, f);
    EXPECT_EQ(repaired(any, options).solid.volume(), 14);
  }
}

TEST(RepairCases, FromMeshResolvesOnRequest) {
  const PolygonMesh mesh = Builder().box({0, 0, 0}, {2, 2, 2}).box({1, 1, 1}, {3, 3, 3}).mesh();
  EXPECT_THROW(Solid::from_mesh(mesh), InvalidSolid);
  ImportOptions options;
  RepairReport report;
  options.report = &report;
  for (const auto& [rule, volume] :
       {std::pair(Rule::positive, 15), std::pair(Rule::nonzero, 15), std::pair(Rule::odd, 14)}) {
    options.resolve = rule;
    EXPECT_EQ(Solid::from_mesh(mesh, options).volume(), volume);
    ASSERT_EQ(report.changes.size(), 1u);
    EXPECT_EQ(report.changes[0].kind, RepairChange::Kind::divided_faces);
  }
  // Holes stay a reason to refuse.
  PolygonMesh open = Builder().box({0, 0, 0}, {2, 2, 2}).mesh();
  open.indices.resize(open.indices.size() - open.face_sizes.back());
  open.face_sizes.pop_back();
  EXPECT_THROW(Solid::from_mesh(open, options), InvalidSolid);
  EXPECT_EQ(report.holes.size(), 1u);
}

// An edge of the cavity lies in the middle of the top: around it there are two wedges of material,
// and what bounds one of them is half of the top and a face of the cavity.
TEST(RepairCases, ACavityThatTouchesAFaceFromWithinIsNoShellOfItsOwn) {
  const PolygonMesh box = Builder().box({0, 0, 0}, {4, 4, 4}).mesh();
  const PolygonMesh wedge{{{2, 2, 4}, {1, 1, 4}, {1, 2, 3}, {2, 1, 3}},
                          {3, 3, 3, 3},
                          {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}};
  const Solid cut = boolean(Solid::from_mesh(box), Solid::from_mesh(wedge), Operation::subtract);
  const Solid repaired = repair(side_by_side(box, turned(wedge)));
  EXPECT_EQ(repaired, cut);
  EXPECT_EQ(cut.counts().shells, 1u);
  EXPECT_EQ(repaired.counts().shells, 1u);
  EXPECT_EQ(repaired.counts().edges, cut.counts().edges);
}

TEST(RepairCases, WhatHasNoAreaIsToldOfOnce) {
  RepairReport report;
  const PolygonMesh flat{{{1, 1, 1}, {2, 2, 2}, {3, 3, 3}}, {3, 3}, {0, 1, 2, 0, 2, 1}};
  EXPECT_TRUE(repair(flat, {}, &report).is_empty());
  ASSERT_EQ(report.changes.size(), 1u);
  EXPECT_EQ(report.changes[0].kind, Kind::removed_flat);
  EXPECT_EQ(report.changes[0].count, 2u);
}

TEST(RepairCases, CanBeCancelled) {
  const std::atomic<bool> cancel{true};
  RepairOptions options;
  options.cancel = &cancel;
  EXPECT_THROW(repair(Builder().box({0, 0, 0}, {1, 1, 1}).mesh(), options), Cancelled);
}

TEST(RepairCases, ProgressRises) {
  double last = 0;
  RepairOptions options;
  options.progress = [&](double done) {
    EXPECT_GE(done, last);
    last = done;
  };
  repair(Builder().box({0, 0, 0}, {1, 1, 1}).box({0.5, 0.5, 0.5}, {2, 2, 2}).mesh(), options);
  EXPECT_EQ(last, 1);
}

}  // namespace
}  // namespace sectile
