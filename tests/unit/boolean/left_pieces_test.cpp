// What is left of blocks of which faces are loaded.
#include "boolean/components/left_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "numbers/disjoint_sets.h"
#include "sectile/sectile.h"
#include "unit/boolean/some_faces.h"

namespace sectile {
namespace {

class LeftOf : public testing::TestWithParam<double> {
 protected:
  const Solid solid_ = sphere(1, 60, 30);
  const SolidData& data_ = *solid_.data();
  const std::vector<FaceId> loaded_ = test::some_faces(data_, GetParam());
  Geometry geometry_;
  const Patch patch_ = load_patch(data_, loaded_, geometry_);
  const LeftPieces left_{patch_};

  const Brep& brep(std::uint32_t slot) const { return data_.slot(slot).block->brep(); }
  FaceId face(const SolidData::Neighbour& n) const { return brep(n.slot).face_of(n.local); }
  bool is_loaded(std::uint32_t slot, FaceId f) const {
    return std::ranges::binary_search(loaded_, data_.face(slot, f));
  }
  template <class Visit>
  void each_face(const Visit& visit) const {
    for (std::uint32_t s = 0; s < data_.slots().size(); ++s)
      if (left_.is_touched(s))
        for (const FaceId f : brep(s).faces()) visit(s, f);
  }
  // What lies there: a face that is loaded, a piece that is left, or one of a block as it is.
  using Beside = std::tuple<int, std::uint32_t, std::uint32_t>;
  Beside beside(const SolidData::Neighbour& n) const {
    const FaceId f = face(n);
    if (is_loaded(n.slot, f)) return {0, n.slot, f.value()};
    if (left_.is_touched(n.slot)) return {1, n.slot, left_.of(n.slot, f)};
    return {2, n.slot, data_.slot(n.slot).block->pieces().of(f)};
  }
};

INSTANTIATE_TEST_SUITE_P(ASphere, LeftOf, testing::Values(0.003, 0.05, 0.4, 0.9, 1),
                         [](const auto& p) {
                           return "Permille" + std::to_string(int(1000 * p.param));
                         });

TEST_P(LeftOf, SlotsWithLoadedFacesAreTouched) {
  std::set<std::uint32_t> slots;
  for (const FaceId f : loaded_) slots.insert(data_.slot_of(f));
  for (std::uint32_t s = 0; s < data_.slots().size(); ++s)
    EXPECT_EQ(left_.is_touched(s), slots.contains(s));
}

TEST_P(LeftOf, PiecesAreWhatHangsTogetherInABlock) {
  std::uint32_t numbers = 0;  // of the solid's faces, with gaps
  each_face([&](std::uint32_t s, FaceId f) {
    numbers = std::max(numbers, data_.face(s, f).value() + 1);
  });
  DisjointSets sets(numbers);
  each_face([&](std::uint32_t s, FaceId f) {
    EXPECT_EQ(left_.of(s, f) == LeftPieces::loaded, is_loaded(s, f));
    for_each_in_face(brep(s), f, [&](HalfEdgeId h) {
      const SolidData::Neighbour across = data_.across(s, h);
      if (across.slot == s && !is_loaded(s, f) && !is_loaded(s, face(across)))
        sets.unite(data_.face(s, f).value(), data_.face(s, face(across)).value());
    });
  });
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> set_of_piece;
  std::set<std::uint32_t> known;
  each_face([&](std::uint32_t s, FaceId f) {
    if (is_loaded(s, f)) return;
    const std::uint32_t piece = left_.of(s, f), set = sets.first(data_.face(s, f).value());
    ASSERT_LT(piece, left_.count(s));
    EXPECT_EQ(left_.of(s, left_.face_of(s, piece)), piece);
    const auto [it, is_new] = set_of_piece.try_emplace({s, piece}, set);
    EXPECT_EQ(it->second, set);
    EXPECT_EQ(known.insert(set).second, is_new);
  });
}

TEST_P(LeftOf, EndsLeadToAllThatIsBesideAPiece) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::set<Beside>> expected, found;
  each_face([&](std::uint32_t s, FaceId f) {
    if (is_loaded(s, f)) return;
    const std::uint32_t piece = left_.of(s, f);
    for_each_in_face(brep(s), f, [&](HalfEdgeId h) {
      const Beside there = beside(data_.across(s, h));
      if (there != Beside{1, s, piece}) expected[{s, piece}].insert(there);
    });
    for (const HalfEdgeId h : left_.ends(s, piece)) {
      EXPECT_EQ(left_.of(s, brep(s).face_of(h)), piece);
      found[{s, piece}].insert(beside(data_.across(s, h)));
    }
  });
  EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace sectile
