// The tour of the paper: what it covers, that each station's step is there, and the page.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "program/phase_picture.h"
#include "program/tour_pictures.h"
#include "tour/station.h"

namespace sectile::viewer {
namespace {

std::size_t words_in(const std::string& text) {
  std::istringstream in(text);
  std::string word;
  std::size_t count = 0;
  while (in >> word) ++count;
  return count;
}

TEST(Tour, CoversEachFigureEachRowAndEachPhase) {
  std::set<std::string> covered;
  for (const Station& station : stations())
    covered.insert(station.covers.begin(), station.covers.end());
  std::set<std::string> wanted{"Table I, \u222A", "Table I, \u2229", "Table I, \\"};
  for (int i = 1; i <= 23; ++i) wanted.insert("figure " + std::to_string(i));
  for (int i = 1; i <= 9; ++i) wanted.insert("Table II, row " + std::to_string(i));
  for (int i = 1; i <= 4; ++i) wanted.insert("Table III, row " + std::to_string(i));
  for (int p = 0; p < 8; ++p) wanted.insert(std::string(name_of(static_cast<Phase>(p))));
  EXPECT_EQ(covered, wanted);
  EXPECT_GE(stations().size(), 24u);
}

TEST(Tour, StationsAreShortAndWhole) {
  std::set<std::string> titles;
  for (const Station& station : stations()) {
    EXPECT_TRUE(titles.insert(station.title).second) << station.title;
    EXPECT_LE(words_in(station.text), 60u) << station.title;
    EXPECT_GE(words_in(station.text), 20u) << station.title;
    EXPECT_EQ(station.question.back(), '?') << station.title;
    EXPECT_FALSE(station.answer.empty());
    EXPECT_GE(station.figure.shapes().size(), 3u) << station.title;
    for (const FigureShape& shape : station.figure.shapes())
      for (const FigurePoint& p : shape.points) {
        EXPECT_TRUE(p.x >= 0 && p.x <= Figure::across) << station.title << ' ' << p.x;
        EXPECT_TRUE(p.y >= 0 && p.y <= Figure::down) << station.title << ' ' << p.y;
      }
  }
}

TEST(Tour, EachStationHasItsStep) {
  for (const Station& station : stations()) {
    const Story story = tell(sample_operands(station.sample));
    const auto [first, last] = story.range(station.phase);
    const auto step = step_of(station, story);
    ASSERT_TRUE(step.has_value()) << station.title;
    EXPECT_TRUE(*step >= first && *step < last);
    EXPECT_EQ(story.step(*step).phase, station.phase);
  }
}

// A station of Table III shows the step in which its row is lit.
TEST(Tour, StationsOfTablesLightTheirRows) {
  for (const Station& station : stations())
    for (const std::string& cover : station.covers) {
      const bool second = cover.starts_with("Table II,"), third = cover.starts_with("Table III,");
      if (!second && !third) continue;
      const Story story = tell(sample_operands(station.sample));
      const Step step = story.step(step_of(station, story).value());
      const std::size_t row = static_cast<std::size_t>(cover.back() - '1');
      bool lit = false;
      for (const PaperTable& table : step.paper)
        if (table.title.starts_with(second ? "Table II:" : "Table III:"))
          lit |= std::count(table.lit_rows.begin(), table.lit_rows.end(), row) > 0;
      EXPECT_TRUE(lit) << station.title << ": " << step.title;
    }
}

TEST(Tour, IsAPageThatNeedsNothingElse) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "sectile-tour";
  std::filesystem::remove_all(folder);
  const std::filesystem::path path = write_tour(folder);
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  const std::string page = text.str();
  std::filesystem::remove_all(folder);
  const auto count = [&](const std::string& what) {
    std::size_t found = 0;
    for (std::size_t at = page.find(what); at != std::string::npos; at = page.find(what, at + 1))
      ++found;
    return found;
  };
  EXPECT_EQ(count("<section "), stations().size());
  EXPECT_EQ(count("src=\"data:image/png;base64,iVBOR"), stations().size());
  EXPECT_EQ(count("<svg "), stations().size());
  EXPECT_EQ(count("<details>"), stations().size());
  EXPECT_EQ(count("http"), 0u);
  EXPECT_EQ(count("href=\"") - count("href=\"#"), 0u);
  EXPECT_LT(page.size(), 3000000u);
}

}  // namespace
}  // namespace sectile::viewer
