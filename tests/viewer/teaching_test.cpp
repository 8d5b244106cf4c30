// Steps as one would teach from them: verdicts, bullets, the paper's tables, names in the picture,
// legends, what is enlarged, and splits in the words of section 3.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "picture/theme.h"
#include "samples/samples.h"
#include "story/paper_tables.h"
#include "story/story.h"

namespace sectile::viewer {
namespace {

Story story_of(const samples::Sample& sample) {
  if (sample.plane) return Story::tell_split(sample.a, {*sample.plane, true}).value();
  return Story::tell(sample.a, sample.b, sample.operation.value());
}
Story story_of(const std::string& name) {
  return story_of(samples::get(name));
}

std::size_t words_in(const std::string& text) {
  std::istringstream in(text);
  std::string word;
  std::size_t count = 0;
  while (in >> word) ++count;
  return count;
}

class Teaching : public testing::TestWithParam<samples::Sample> {
 protected:
  const Story story = story_of(GetParam());
};

TEST_P(Teaching, VerdictsHaveThreeWordsAndAtMostThreeShortBulletsFollow) {
  for (std::size_t i = 0; i < story.steps().size(); ++i) {
    const Step step = story.step(i);
    EXPECT_EQ(words_in(step.verdict.words), 3u) << step.verdict.words;
    EXPECT_FALSE(step.bullets.empty()) << step.title;
    EXPECT_LE(step.bullets.size(), 3u) << step.title;
    for (const std::string& bullet : step.bullets) EXPECT_LE(words_in(bullet), 26u) << bullet;
    for (const PaperTable& table : step.paper) {
      EXPECT_FALSE(table.lit_rows.empty()) << step.title;
      for (const std::size_t row : table.lit_rows) EXPECT_LT(row, table.rows.size());
      for (const std::size_t column : table.lit_columns) EXPECT_LT(column, table.columns.size());
      for (const Row& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
    }
  }
}

// Of A and of B, as titles name them: "A e3", "B f7".
std::set<std::string> named(const Step& step) {
  std::set<std::string> names;
  for (int s = 0; s < 2; ++s) {
    std::istringstream in(s == 0 ? step.a : step.b);
    for (std::string name; in >> name;) names.insert((s == 0 ? "A " : "B ") + name);
  }
  return names;
}

TEST_P(Teaching, WhatIsNamedIsLabelledInThePicture) {
  if (GetParam().plane) return;  // the plane has one name
  for (std::size_t i = 0; i < story.steps().size(); ++i) {
    const Step step = story.step(i);
    if (step.phase >= Phase::components) continue;
    std::set<std::string> labels;
    for (const Label& label : story.picture(i, {}).labels) labels.insert(label.text);
    for (const std::string& name : named(step)) EXPECT_TRUE(labels.contains(name)) << name;
  }
}

bool in_legend(const Picture& picture, const Colour& colour) {
  return std::any_of(picture.legend.begin(), picture.legend.end(), [&](const LegendKey& key) {
    return glm::vec3(key.colour) == glm::vec3(colour);
  });
}

bool in_picture(const Picture& picture, const Colour& colour) {
  const auto same = [&](const auto& thing) { return glm::vec3(thing.colour) == glm::vec3(colour); };
  return std::any_of(picture.surfaces.begin(), picture.surfaces.end(), same) ||
         std::any_of(picture.lines.begin(), picture.lines.end(), same) ||
         std::any_of(picture.points.begin(), picture.points.end(), same);
}

TEST_P(Teaching, LegendsNameExactlyTheColoursInUse) {
  for (const bool dark : {false, true})
    for (std::size_t i = 0; i < story.steps().size(); ++i) {
      StoryView view;
      view.dark = dark;
      const Picture picture = story.picture(i, view);
      for (const Surface& surface : picture.surfaces)
        EXPECT_TRUE(in_legend(picture, surface.colour)) << story.step(i).title;
      for (const Lines& lines : picture.lines)
        EXPECT_TRUE(in_legend(picture, lines.colour)) << story.step(i).title;
      for (const Points& points : picture.points)
        EXPECT_TRUE(in_legend(picture, points.colour)) << story.step(i).title;
      std::set<std::string> texts;
      for (const LegendKey& key : picture.legend) {
        EXPECT_TRUE(in_picture(picture, key.colour)) << key.text << ", " << story.step(i).title;
        texts.insert(key.text);
      }
      EXPECT_FALSE(texts.empty());
    }
}

TEST_P(Teaching, RowsOfTablesAreLit) {
  for (std::size_t i = 0; i < story.steps().size(); ++i) {
    const Step step = story.step(i);
    ASSERT_EQ(step.row_faces.size(), step.table.size());
    for (std::size_t row = 0; row < step.table.size(); ++row) {
      if (step.row_faces[row].empty()) continue;
      if (step.phase == Phase::gluing || step.phase == Phase::reduction) continue;
      StoryView view;
      view.lit_row = static_cast<int>(row);
      EXPECT_GT(story.picture(i, view).surfaces.size(), story.picture(i, {}).surfaces.size())
          << step.title << ", row " << row;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Figures, Teaching, testing::ValuesIn(samples::all()), [](const auto& one) {
  std::string name = one.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(TeachingTables, AreThoseOfThePaperWithItsErrataMended) {
  const std::array operations = {Operation::unite, Operation::intersect, Operation::subtract};
  const PaperTable one = table_1();
  for (const Operation operation : operations)
    for (int solid = 0; solid < 2; ++solid)
      for (int against = 0; against < 2; ++against) {
        const TraceClass to = reclassified(
            operation, solid, against == 0 ? TraceClass::on_plus : TraceClass::on_minus);
        EXPECT_EQ(one.rows[row_of(operation)][static_cast<std::size_t>(1 + 2 * solid + against)],
                  part_name(solid, to));
      }
  // Table III says of Table I whether the sector is reclassified out; its columns are ∪ \ ∩.
  const PaperTable three = table_3();
  const std::array columns = {Operation::unite, Operation::subtract, Operation::intersect};
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_EQ(
          three.rows[row][2 + c] == "yes",
          reclassified(columns[c], static_cast<int>(row % 2),
                       row < 2 ? TraceClass::on_plus : TraceClass::on_minus) == TraceClass::out);
}

TEST(TeachingTables, LightTheRowOfEverySampleOfTableTwo) {
  for (int row = 1; row <= 9; ++row) {
    const Story story = story_of("table2-row" + std::to_string(row));
    bool lit = false;
    for (std::size_t i = 0; i < story.steps().size(); ++i)
      for (const PaperTable& table : story.step(i).paper)
        if (table.title.starts_with("Table II:"))
          for (const std::size_t r : table.lit_rows)
            lit |= r + 1 == static_cast<std::size_t>(row) ||
                   // The same edge from its other end.
                   (table.rows[r][1] == table_2().rows[static_cast<std::size_t>(row) - 1][2] &&
                    table.rows[r][2] == table_2().rows[static_cast<std::size_t>(row) - 1][1]);
    EXPECT_TRUE(lit) << row;
  }
}

TEST(TeachingSplit, IsToldInTheWordsOfSectionThree) {
  const Story story = story_of("fig04");
  bool above = false, on = false, below = false;
  for (std::size_t i = 0; i < story.steps().size(); ++i) {
    const Step step = story.step(i);
    std::string all = step.title + " " + step.words + " " + step.verdict.words;
    for (const std::string& bullet : step.bullets) all += " " + bullet;
    for (const char* foreign : {" of B", "AinB", "AoutB", "BinA", " \u2229 ", "of A "})
      EXPECT_EQ(all.find(foreign), std::string::npos) << foreign << ": " << all;
    for (const Row& row : step.table)
      for (const std::string& cell : row) {
        above |= cell == "above";
        on |= cell == "on";
        below |= cell == "below";
      }
    for (const LegendKey& key : story.picture(i, {}).legend) EXPECT_NE(key.text, "B") << step.title;
  }
  EXPECT_TRUE(above && on && below);
}

TEST(TeachingPictures, EnlargeWhatIsTooSmallAndSaySo) {
  const Story story = story_of("fig23");
  int enlarged = 0;
  for (std::size_t i = 0; i < story.steps().size(); ++i) {
    const Picture picture = story.picture(i, {});
    enlarged += std::any_of(picture.labels.begin(), picture.labels.end(),
                            [](const Label& label) { return label.text.starts_with("enlarged"); });
  }
  EXPECT_GT(enlarged, 0);
  // In an ordinary figure nothing is.
  const Story plain = story_of("fig11");
  for (std::size_t i = 0; i < plain.steps().size(); ++i)
    for (const Label& label : plain.picture(i, {}).labels)
      EXPECT_FALSE(label.text.starts_with("enlarged"));
}

TEST(TeachingPictures, NullEdgesOfPlacesThatCoincideAreDrawnApartAndSaidSo) {
  const Story story = story_of("fig23");
  const auto [first, end] = story.range(Phase::null_edges);
  const Theme& colours = theme(false);
  int apart = 0;
  for (std::size_t i = first; i < end; ++i) {
    const Picture picture = story.picture(i, {});
    const bool said = std::any_of(picture.labels.begin(), picture.labels.end(),
                                  [](const Label& l) { return l.text.starts_with("enlarged"); });
    if (!said) continue;
    for (const Lines& lines : picture.lines) {
      if (glm::vec3(lines.colour) != glm::vec3(colours.step)) continue;
      const double length = glm::distance(lines.ends.at(0), lines.ends.at(1));
      EXPECT_GT(length, 0.05 * picture.bounds().radius()) << story.step(i).title;
      ++apart;
    }
  }
  EXPECT_GE(apart, 2);
}

// --- Colours as people with colour-blindness see them ---

glm::dvec3 linear(const Colour& colour) {
  glm::dvec3 made;
  for (int i = 0; i < 3; ++i) {
    const double v = static_cast<double>(colour[i]);
    made[i] = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  }
  return made;
}

// Rows of the matrices of Machado, Oliveira and Fernandes (2009) for full severity.
constexpr double no_red[3][3] = {{0.152286, 1.052583, -0.204868},
                                 {0.114503, 0.786281, 0.099216},
                                 {-0.003882, -0.048116, 1.051998}};
constexpr double no_green[3][3] = {{0.367322, 0.860646, -0.227968},
                                   {0.280085, 0.672501, 0.047413},
                                   {-0.011820, 0.042940, 0.968881}};
constexpr double no_blue[3][3] = {{1.255528, -0.076749, -0.178779},
                                  {-0.078411, 0.930809, 0.147602},
                                  {0.004733, 0.691367, 0.303900}};
constexpr double all_cones[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

glm::dvec3 seen(const Colour& colour, const double (&matrix)[3][3]) {
  const glm::dvec3 in = linear(colour);
  glm::dvec3 out(0);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) out[i] += matrix[i][j] * in[j];
    out[i] = std::clamp(out[i], 0.0, 1.0);
  }
  return out;
}

// CIE L*a*b* under D65.
glm::dvec3 lab(const glm::dvec3& c) {
  const double x = (0.4124 * c.x + 0.3576 * c.y + 0.1805 * c.z) / 0.9505,
               y = 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z,
               z = (0.0193 * c.x + 0.1192 * c.y + 0.9505 * c.z) / 1.089;
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
  return {116 * f(y) - 16, 500 * (f(x) - f(y)), 200 * (f(y) - f(z))};
}

TEST(TeachingColours, MarksAreToldApartWithEveryKindOfColourBlindness) {
  constexpr double least = 18;  // a difference of 2 is just seen side by side
  for (const bool dark : {false, true}) {
    const Theme& t = theme(dark);
    const std::vector<std::pair<const char*, Colour>> marks = {
        {"coincident", t.coincident},
        {"this step", t.step},
        {"other contacts", t.contact},
        {"null edge above", t.null_edge_above},
        {"null edge below", t.null_edge_below}};
    const double(*const kinds[4])[3] = {all_cones, no_red, no_green, no_blue};
    for (std::size_t k = 0; k < 4; ++k) {
      double matrix[3][3];
      std::copy(&kinds[k][0][0], &kinds[k][0][0] + 9, &matrix[0][0]);
      for (std::size_t i = 0; i < marks.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          EXPECT_GT(
              glm::distance(lab(seen(marks[i].second, matrix)), lab(seen(marks[j].second, matrix))),
              least)
              << marks[i].first << " and " << marks[j].first << (dark ? ", dark" : ", light")
              << ", kind " << k;
    }
  }
}

}  // namespace
}  // namespace sectile::viewer
