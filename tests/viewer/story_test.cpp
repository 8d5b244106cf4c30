// The story of every figure: steps, words, sphere pictures and pictures.
#include "story/story.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "samples/samples.h"
#include "sectile/errors.h"

namespace sectile::viewer {
namespace {

constexpr Phase all_phases[] = {Phase::reduction,  Phase::vertex_face, Phase::vertex_vertex,
                                Phase::null_edges, Phase::joining,     Phase::components,
                                Phase::gluing,     Phase::cleanup};

std::vector<samples::Sample> pairs() {
  std::vector<samples::Sample> found;
  for (const samples::Sample& sample : samples::all())
    if (!sample.b.is_empty()) found.push_back(sample);
  return found;
}

class StoryTest : public testing::TestWithParam<samples::Sample> {
 protected:
  const Story story = Story::tell(GetParam().a, GetParam().b, GetParam().operation.value());
};

TEST_P(StoryTest, EveryStepHasATitleAndWords) {
  ASSERT_FALSE(story.steps().empty());
  for (std::size_t i = 0; i < story.steps().size(); ++i) {
    const Step step = story.step(i);
    EXPECT_FALSE(step.title.empty());
    EXPECT_GT(step.words.size(), 20u);
    EXPECT_FALSE(step.columns.empty());
    for (const Row& row : step.table) EXPECT_EQ(row.size(), step.columns.size()) << step.title;
  }
}

TEST_P(StoryTest, EveryStepHasAPicture) {
  StoryView view;
  view.labels = true;
  for (std::size_t i = 0; i < story.steps().size(); ++i) {
    const Picture picture = story.picture(i, view);
    EXPECT_FALSE(picture.bounds().is_empty()) << story.step(i).title;
    EXPECT_FALSE(story.place_of(i).is_empty());
  }
  for (const Phase phase : all_phases) EXPECT_FALSE(story.picture(phase, view).surfaces.empty());
}

// Entities as they print: a letter and a number.
std::vector<std::string> entities(const std::string& text) {
  std::vector<std::string> found;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool starts = (i == 0 || text[i - 1] == ' ') && std::string("vef").find(text[i]) < 3;
    std::size_t end = i + 1;
    while (end < text.size() && text[end] >= '0' && text[end] <= '9') ++end;
    if (starts && end > i + 1) found.push_back(text.substr(i, end - i));
  }
  return found;
}

TEST_P(StoryTest, TitlesNameTheEntitiesConcerned) {
  for (std::size_t i = 0; i < story.steps().size(); ++i) {
    const Step step = story.step(i);
    const std::vector<std::string> titled = entities(step.title);
    for (const std::string& names : {step.a, step.b})
      for (const std::string& name : entities(names))
        EXPECT_NE(std::find(titled.begin(), titled.end(), name), titled.end()) << step.title;
    if (!step.a.empty()) {
      EXPECT_NE(step.title.find('A'), std::string::npos) << step.title;
    }
    if (!step.b.empty()) {
      EXPECT_NE(step.title.find('B'), std::string::npos) << step.title;
    }
  }
}

TEST_P(StoryTest, PhasesFollowEachOther) {
  std::size_t expected = 0;
  for (const Phase phase : all_phases) {
    const auto [first, last] = story.range(phase);
    EXPECT_EQ(first, expected);
    for (std::size_t i = first; i < last; ++i) {
      EXPECT_EQ(story.steps()[i].phase, phase);
      EXPECT_EQ(story.step(i).phase, phase);
    }
    expected = last;
  }
  EXPECT_EQ(expected, story.steps().size());
}

// Going once around a place in a surface one comes back: what arcs leave, arcs reach.
TEST_P(StoryTest, ArcsOnTheSphereAreClosed) {
  for (std::size_t i = 0; i < story.steps().size(); ++i) {
    const SpherePicture sphere = story.step(i).sphere;
    for (int s = 0; s < 2; ++s) {
      std::vector<glm::vec3> open;
      for (const SpherePicture::Arc& arc : sphere.arcs)
        if (arc.solid == s) open.push_back(arc.to);
      EXPECT_EQ(open.empty(), sphere.is_empty());
      for (const SpherePicture::Arc& arc : sphere.arcs) {
        EXPECT_NEAR(glm::length(arc.from), 1, 1e-5);
        EXPECT_NEAR(glm::dot(arc.from, arc.normal), 0, 1e-5);
        EXPECT_NEAR(glm::dot(arc.to, arc.normal), 0, 1e-5);
        if (arc.solid != s) continue;
        const auto next = std::find_if(open.begin(), open.end(), [&](const glm::vec3& to) {
          return glm::length(to - arc.from) < 1e-5f;
        });
        ASSERT_NE(next, open.end()) << story.step(i).title << ": " << arc.label;
        open.erase(next);
      }
      EXPECT_TRUE(open.empty());
    }
  }
}

// Once something is classified, all sectors at its ends are.
TEST_P(StoryTest, SectorsHaveTheirClasses) {
  for (const Phase phase : {Phase::vertex_face, Phase::vertex_vertex, Phase::joining})
    for (auto [i, last] = story.range(phase); i < last; ++i)
      for (const SpherePicture::Arc& arc : story.step(i).sphere.arcs)
        EXPECT_TRUE(arc.cls.has_value()) << story.step(i).title << ": " << arc.label;
}

// By an observer of the story: the last class is in or out, and is kept as equation (4) says.
TEST_P(StoryTest, TablesFollowEquationFour) {
  for (const Phase phase : {Phase::vertex_face, Phase::vertex_vertex})
    for (auto [i, last] = story.range(phase); i < last; ++i) {
      const Step step = story.step(i);
      ASSERT_EQ(step.columns[4], "reclassified");
      for (const Row& row : step.table) {
        const bool outside = story.operation() == Operation::unite ||
                             (story.operation() == Operation::subtract && row[0] == "A");
        EXPECT_EQ(row[6], row[4] == (outside ? "out" : "in") ? "kept" : "dropped");
        EXPECT_EQ(row[5].empty(), row[3] == row[4]) << step.title;
      }
    }
}

TEST_P(StoryTest, EndsOfNullEdgesAreApart) {
  for (auto [i, last] = story.range(Phase::null_edges); i < last; ++i) {
    const Picture picture = story.picture(i, StoryView{});
    ASSERT_FALSE(picture.lines.empty());
    for (const Lines& lines : picture.lines)
      for (std::size_t k = 0; k + 1 < lines.ends.size(); k += 2)
        EXPECT_GT(glm::length(lines.ends[k] - lines.ends[k + 1]), 0.003f) << story.step(i).title;
  }
}

// What the present step names is labelled in any case.
TEST_P(StoryTest, LabelsOfEarlierStepsComeWhenAskedFor) {
  StoryView with;
  with.labels = true;
  for (std::size_t i = 0; i < story.steps().size(); ++i) {
    const std::size_t asked = story.picture(i, with).labels.size(),
                      present = story.picture(i, StoryView{}).labels.size();
    const std::size_t earlier = i - story.range(story.step(i).phase).first;
    const bool placed = story.step(i).phase < Phase::components && earlier <= 60;
    EXPECT_EQ(asked - present, placed ? earlier : asked - present);
    EXPECT_LE(present, 12u);
  }
}

std::string all_text(const Story& story) {
  std::string text;
  for (std::size_t i = 0; i < story.steps().size(); ++i) {
    const Step step = story.step(i);
    text += step.kind + step.title + step.words + step.a + step.b + (step.special ? "!" : "");
    for (const Row& row : step.table)
      for (const std::string& cell : row) text += cell;
    for (const SpherePicture::Arc& arc : step.sphere.arcs) {
      text += arc.label;
      if (arc.cls) text += name_of(*arc.cls);
    }
  }
  return text;
}

TEST_P(StoryTest, IsToldTheSameWayTwice) {
  const Story again = Story::tell(GetParam().a, GetParam().b, GetParam().operation.value());
  EXPECT_EQ(all_text(story), all_text(again));
  EXPECT_TRUE(story.result() == again.result());
}

TEST_P(StoryTest, OneIsNoPlural) {
  for (std::size_t i = 0; i < story.steps().size(); ++i) {
    const std::string words = " " + story.step(i).words;
    for (const char* wrong : {" 1 faces", " 1 edges", " 1 vertices", " 1 shells", " 1 cuts"})
      EXPECT_EQ(words.find(wrong), std::string::npos) << words;
  }
}

TEST(Story, OfAnEmptySolidIsItsResult) {
  const Solid block = samples::get("fig11").a;
  const Story story = Story::tell(Solid(), block, Operation::unite);
  ASSERT_EQ(story.steps().size(), 1u);
  EXPECT_EQ(story.step(0).kind, "result");
  EXPECT_FALSE(story.picture(0, StoryView{}).surfaces.empty());
  EXPECT_TRUE(Story().steps().empty());
}

TEST(Story, CanBeCancelled) {
  const std::atomic<bool> cancel = true;
  const samples::Sample sample = samples::get("fig11");
  EXPECT_THROW(Story::tell(sample.a, sample.b, Operation::unite, &cancel), Cancelled);
}

std::string test_name(const testing::TestParamInfo<samples::Sample>& sample) {
  std::string name = sample.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Samples, StoryTest, testing::ValuesIn(pairs()), test_name);

}  // namespace
}  // namespace sectile::viewer
