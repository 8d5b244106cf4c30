// The story of every figure: steps, words, sphere pictures and pictures.
#include "story/story.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "samples/samples.h"

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

std::string test_name(const testing::TestParamInfo<samples::Sample>& sample) {
  std::string name = sample.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Samples, StoryTest, testing::ValuesIn(pairs()), test_name);

}  // namespace
}  // namespace sectile::viewer
