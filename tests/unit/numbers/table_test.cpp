// Tables, which only ids of their own elements index, and ranges of ids.
#include "numbers/table.h"

#include <gtest/gtest.h>

#include <concepts>
#include <string>

#include "numbers/id.h"

namespace sectile {
namespace {

template <class Container, class Index>
concept Indexable = requires(Container c, Index i) {
  c[i];
};

using Names = Table<FaceId, std::string>;
static_assert(Indexable<Names, FaceId>);
static_assert(!Indexable<Names, EdgeId>);
static_assert(!Indexable<Names, std::size_t>);
static_assert(!Indexable<Names, int>);

TEST(Table, GivesNewElementsTheirIds) {
  Names names;
  EXPECT_FALSE(names.has(FaceId(0)));
  EXPECT_EQ(names.add("top"), FaceId(0));
  EXPECT_EQ(names.add("bottom"), FaceId(1));
  EXPECT_EQ(names.end_id(), FaceId(2));
  EXPECT_EQ(names[FaceId(1)], "bottom");
  std::string all;
  for (const FaceId f : names.ids()) all += names[f] + " ";
  EXPECT_EQ(all, "top bottom ");
  names.resize(3, "side");
  EXPECT_EQ(names.ids_from(FaceId(2)).size(), 1u);
  EXPECT_EQ(names[names.ids_from(FaceId(1))].back(), "side");
}

// So many are filled on all cores.
TEST(Table, FillsVeryManyNewElementsAndNoOthers) {
  constexpr std::size_t few = 5, many = 1000000;
  Table<FaceId, EdgeId> edges(few, EdgeId(7));
  edges[FaceId(2)] = EdgeId(8);
  edges.resize(many, edges[FaceId(2)]);
  ASSERT_EQ(edges.size(), many);
  EXPECT_EQ(edges[FaceId(1)], EdgeId(7));
  for (const FaceId f : edges.ids_from(FaceId(few))) ASSERT_EQ(edges[f], EdgeId(8));
  edges.assign(many, EdgeId(9));
  for (const EdgeId e : edges) ASSERT_EQ(e, EdgeId(9));
  edges.clear();
  edges.resize(many);
  for (const EdgeId e : edges) ASSERT_FALSE(e.valid());
}

TEST(IdRange, KnowsItsIds) {
  IdRange<EdgeId> range(EdgeId(3), EdgeId(3));
  EXPECT_TRUE(range.empty());
  range.extend();
  range.extend();
  EXPECT_EQ(range.size(), 2u);
  EXPECT_EQ(range.front(), EdgeId(3));
  EXPECT_EQ(range.back(), EdgeId(4));
  EXPECT_EQ(range.end_id(), EdgeId(5));
  EXPECT_EQ(range[1], EdgeId(4));
  EXPECT_EQ(range.index(EdgeId(4)), 1u);
  EXPECT_TRUE(range.contains(EdgeId(4)));
  EXPECT_FALSE(range.contains(EdgeId(5)));
  EXPECT_FALSE(range.contains(EdgeId(2)));
}

}  // namespace
}  // namespace sectile
