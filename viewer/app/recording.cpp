#include "app/recording.h"

#include <cstdio>
#include <glm/gtc/constants.hpp>

#include "app/results.h"
#include "app/view_state.h"
#include "render/gif.h"
#include "render/renderer.h"

namespace sectile::viewer {
namespace {

constexpr std::uint32_t most_pixels = 16384;
constexpr std::size_t most_bytes = std::size_t{3} << 30;

std::size_t frames_of(const RecordingPlan& plan, const Results& results) {
  if (plan.kind == RecordingPlan::Kind::turntable) return plan.frames;
  if (plan.kind == RecordingPlan::Kind::picture) return 1;
  const Story* story = results.player.story();
  return story ? story->steps().size() : 0;
}

}  // namespace

std::string problem_of(const RecordingPlan& plan, const Results& results) {
  if (plan.width < 16 || plan.height < 16 || plan.width > most_pixels || plan.height > most_pixels)
    return "Width and height must be from 16 to 16384 pixels.";
  const std::size_t frames = frames_of(plan, results);
  if (plan.kind == RecordingPlan::Kind::steps && frames == 0)
    return "There are no steps to film: show the steps of an operation first (Tab).";
  if (frames == 0) return "A film needs at least one frame.";
  if (std::size_t{plan.width} * plan.height * 4 * frames > most_bytes)
    return "So many frames of this size do not fit into memory: choose a smaller size or fewer.";
  return {};
}

std::filesystem::path numbered(const std::filesystem::path& path, std::size_t frame,
                               std::size_t frames) {
  const int digits = static_cast<int>(std::max<std::size_t>(3, std::to_string(frames).size()));
  char number[32];
  std::snprintf(number, sizeof number, "-%0*zu", digits, frame + 1);
  return path.parent_path() / (path.stem().string() + number + path.extension().string());
}

void write_recording(const RecordingPlan& plan, const std::vector<Image>& images) {
  if (plan.path.extension() == ".gif")
    return write_gif(plan.path.string(), images, plan.seconds_per_frame);
  if (!plan.is_film()) return write_png(plan.path.string(), images.front());
  for (std::size_t i = 0; i < images.size(); ++i)
    write_png(numbered(plan.path, i, images.size()).string(), images[i]);
}

Recording::Recording(RecordingPlan plan, Results& results, const ViewState& view)
    : plan_(std::move(plan)),
      frames_(frames_of(plan_, results)),
      camera_(view.camera),
      step_(results.player.step()) {
  results.player.play(false);
}

bool Recording::prepare(Results& results, ViewState& view) {
  if (images_.size() >= frames_) {
    stop(results, view);
    return false;
  }
  if (plan_.kind == RecordingPlan::Kind::turntable) {
    const double part = static_cast<double>(images_.size()) / static_cast<double>(frames_);
    view.camera = camera_;
    view.camera.azimuth = camera_.azimuth + glm::two_pi<double>() * part;
  }
  if (plan_.kind == RecordingPlan::Kind::steps) results.player.go_to(images_.size());
  return true;
}

void Recording::stop(Results& results, ViewState& view) const {
  view.camera = camera_;
  if (plan_.kind == RecordingPlan::Kind::steps) results.player.go_to(step_);
}

}  // namespace sectile::viewer
