// Solids as text with their exact numbers.
#include <gtest/gtest.h>

#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

#include "boolean/save_operands.h"
#include "sectile/sectile.h"
#include "storage/solid_data.h"

namespace sectile {
namespace {

std::string text_of(const Solid& solid) {
  std::ostringstream out;
  write_exact(out, solid);
  return out.str();
}

Solid solid_of(const std::string& text) {
  std::istringstream in(text);
  return read_exact(in, "here");
}

// Also the numbers of everything, if it is no more than one block.
void expect_kept(const Solid& solid) {
  const std::string text = text_of(solid);
  const Solid back = solid_of(text);
  EXPECT_EQ(back, solid);
  EXPECT_TRUE(validate(back).empty());
  EXPECT_EQ(back.volume(), solid.volume());
  if (solid.data()->slots().size() == 1) {
    EXPECT_EQ(text_of(back), text);
  }
}

const Transform odd_turn = Transform::rotation_degrees({1, 2, 3}, 17);

TEST(ExactFile, KeepsGivenPoints) {
  expect_kept(block({0.1, 0.2, 0.3}, {1, 2, 0x1p-1070 + 3}));
  expect_kept(sphere(1, 12, 6));
}

TEST(ExactFile, KeepsPointsOfPlanesAndHoles) {
  const Solid drilled =
      boolean(block({-2, -2, -0.5}, {2, 2, 0.3}), sphere(1, 12, 6), Operation::subtract);
  expect_kept(drilled);
  expect_kept(split(drilled, {1, 2, 3, 0.1}).first);
}

TEST(ExactFile, KeepsMovedPoints) {
  Solid solid = boolean(transformed(sphere(1, 12, 6), odd_turn), block({0, 0, 0}, {2, 2, 2}),
                        Operation::unite);
  expect_kept(transformed(transformed(solid, odd_turn), odd_turn));
  expect_kept(transformed(split(solid, {1, 2, 3, 0.1}).second, odd_turn));
}

TEST(ExactFile, KeepsSourcesAndEdgesInPlanes) {
  // Two flush faces of different solids, with an edge between them.
  const Solid solid =
      boolean(block({0, 0, 0}, {1, 1, 1}), block({0.5, 0.5, 0}, {2, 2, 1}), Operation::unite);
  expect_kept(solid);
  std::vector<FaceSource> sources, back;
  solid.to_mesh(sources);
  solid_of(text_of(solid)).to_mesh(back);
  // In which order depends on the blocks, which are cut anew.
  std::sort(sources.begin(), sources.end());
  std::sort(back.begin(), back.end());
  EXPECT_EQ(back, sources);
}

TEST(ExactFile, KeepsNothing) {
  EXPECT_TRUE(solid_of(text_of(Solid())).is_empty());
}

TEST(ExactFile, AnyPartOfAFileIsRefused) {
  const std::string text = text_of(block({0, 0, 0}, {1, 2, 3}));
  for (std::size_t end = 0; end + 2 < text.size(); end += 7)
    EXPECT_THROW(solid_of(text.substr(0, end)), FileError) << end;
}

TEST(ExactFile, AnyChangedWordIsRefusedOrRead) {
  const std::string text = text_of(split(sphere(1, 6, 3), {1, 2, 3, 0.1}).first);
  std::size_t refused = 0;
  for (std::size_t at = 0; at < text.size(); at += 5)
    for (const char c : {'9', ' ', 'x'}) {
      std::string changed = text;
      changed[at] = c;
      try {
        solid_of(changed);
      } catch (const FileError&) {
        ++refused;
      }
    }
  EXPECT_GT(refused, text.size() / 5);
}

// The names in the words about where operands were saved.
std::vector<std::string> names_in(const std::string& words) {
  static const std::regex name("[^ ]+\\.exact");
  return {std::sregex_token_iterator(words.begin(), words.end(), name), {}};
}

TEST(SavedOperands, AreExactAndTheUsersOwn) {
  const Solid a = split(transformed(sphere(1, 12, 6), odd_turn), {1, 2, 3, 0.1}).first,
              b = block({0, 0, 0}, {1, 2, 3});
  const std::vector<std::string> names = names_in(save_operands(a, b)),
                                 others = names_in(save_operands(a, b));
  ASSERT_EQ(names.size(), 2u);
  ASSERT_EQ(others.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NE(names[i], others[i]);
    struct stat status {};
    ASSERT_EQ(stat(names[i].c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777u, 0600u);
    std::ifstream in(names[i]);
    EXPECT_EQ(read_exact(in, names[i]), i == 0 ? a : b);
    EXPECT_EQ(remove(names[i].c_str()), 0);
    EXPECT_EQ(remove(others[i].c_str()), 0);
  }
}

}  // namespace
}  // namespace sectile
