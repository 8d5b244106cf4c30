// The command line of the viewer, and its pictures of steps.
#include <gtest/gtest.h>

#include <stdexcept>

#include "program/arguments.h"
#include "program/story_screenshot.h"
#include "render/image_difference.h"

namespace sectile::viewer {
namespace {

std::variant<Arguments, ExitCode> parsed(std::vector<std::string> words) {
  words.insert(words.begin(), "sectile-viewer");
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  return parse_arguments(static_cast<int>(pointers.size()), pointers.data());
}

Arguments good(const std::vector<std::string>& words) {
  auto result = parsed(words);
  if (!std::holds_alternative<Arguments>(result)) throw std::logic_error("refused");
  return std::get<Arguments>(result);
}

bool is_refused(const std::vector<std::string>& words) {
  const auto result = parsed(words);
  const auto* code = std::get_if<ExitCode>(&result);
  return code && *code == ExitCode::usage;
}

TEST(Arguments, AreRead) {
  const Arguments a =
      good({"a.obj",      "b.stl",       "--size",   "640x480",        "--scale",
            "2",          "--dark",      "--camera", "30,20,5,1,2,3",  "--phase",
            "null-edges", "--step",      "4",        "--no-interface", "--screenshot",
            "out.png",    "--operation", "subtract", "--exploded",     "0.5",
            "--eight-way"});
  EXPECT_EQ(a.files.size(), 2u);
  EXPECT_EQ(a.width, 640);
  EXPECT_EQ(a.height, 480);
  EXPECT_EQ(a.scale, 2);
  EXPECT_TRUE(a.dark);
  EXPECT_EQ(a.camera->target, glm::dvec3(1, 2, 3));
  EXPECT_EQ(a.phase, Phase::null_edges);
  EXPECT_EQ(a.step, 4u);
  EXPECT_TRUE(a.is_story_picture());
  EXPECT_EQ(a.operation, Operation::subtract);
  EXPECT_EQ(a.exploded, 0.5);
  EXPECT_TRUE(a.eight_way);
  EXPECT_EQ(good({"--phase", "4"}).phase, Phase::null_edges);
  EXPECT_FALSE(good({"--sample", "fig13"}).is_story_picture());
}

TEST(Arguments, Films) {
  const Arguments turn = good({"--turntable", "a.gif", "--frames", "12", "--seconds", "0.5"});
  EXPECT_EQ(turn.film->kind, RecordingPlan::Kind::turntable);
  EXPECT_EQ(turn.film->frames, 12u);
  EXPECT_EQ(turn.film->seconds_per_frame, 0.5);
  EXPECT_EQ(good({"--film-steps", "a.png"}).film->kind, RecordingPlan::Kind::steps);
  EXPECT_FALSE(good({"--sample", "fig13"}).film);
  EXPECT_TRUE(is_refused({"--turntable", "a.jpg"}));
  EXPECT_TRUE(is_refused({"--turntable", "a.gif", "--film-steps", "b.gif"}));
  EXPECT_TRUE(is_refused({"--frames", "12"}));
  EXPECT_TRUE(is_refused({"--turntable", "a.gif", "--frames", "0"}));
}

TEST(Arguments, NonsenseIsRefused) {
  EXPECT_TRUE(is_refused({"--size", "640"}));
  EXPECT_TRUE(is_refused({"--size", "0x480"}));
  EXPECT_TRUE(is_refused({"--camera", "1,2"}));
  EXPECT_TRUE(is_refused({"--camera", "1,2,x"}));
  EXPECT_TRUE(is_refused({"--camera", "1,2,-3"}));
  EXPECT_TRUE(is_refused({"--phase", "lunch"}));
  EXPECT_TRUE(is_refused({"--step", "2"}));
  EXPECT_TRUE(is_refused({"--sample", "fig99"}));
  EXPECT_TRUE(is_refused({"--exploded", "2"}));
  EXPECT_TRUE(is_refused({"--eight-way", "--sample", "fig13"}));
  EXPECT_TRUE(is_refused({"--bogus"}));
}

TEST(Arguments, CameraLooksAtWhatThereIs) {
  Bounds all;
  all.add(glm::dvec3(1, 1, 1));
  all.add(glm::dvec3(3, 3, 3));
  const Camera camera = CameraWish{90, 0, 0, std::nullopt}.applied_to({}, all, 1.6);
  EXPECT_EQ(camera.target, glm::dvec3(2, 2, 2));
  EXPECT_NEAR(camera.position().x, 2, 1e-9);
  EXPECT_GT(camera.position().y, 4);
}

TEST(StoryScreenshot, ShowsStepsAndIsDeterministic) {
  Arguments arguments = good(
      {"--sample", "fig02", "--size", "320x240", "--no-interface", "--screenshot", "unused.png"});
  const Image operands = story_screenshot(arguments);
  EXPECT_EQ(operands.width, 320);
  arguments.phase = Phase::joining;
  const Image joined = story_screenshot(arguments);
  EXPECT_EQ(joined.rgba, story_screenshot(arguments).rgba);
  EXPECT_GT(compare_images(operands, joined).share, 0.005);
  arguments.phase = Phase::components;
  const Image parts = story_screenshot(arguments);
  arguments.exploded = 1;
  EXPECT_GT(compare_images(parts, story_screenshot(arguments)).share, 0.01);
  arguments.dark = true;
  EXPECT_GT(compare_images(parts, story_screenshot(arguments)).share, 0.3);
  arguments.step = 1000000;
  EXPECT_THROW(story_screenshot(arguments), std::invalid_argument);
}

}  // namespace
}  // namespace sectile::viewer
