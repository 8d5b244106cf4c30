#include "program/tour_pictures.h"

#include <algorithm>
#include <stdexcept>

#include "picture/theme.h"
#include "program/phase_picture.h"
#include "render/renderer.h"
#include "sectile/files.h"
#include "tour/page.h"

namespace sectile::viewer {
namespace {

constexpr int width = 560, height = 360;

// Shades that nobody tells apart make files large.
Image with_fewer_shades(Image image) {
  for (std::uint8_t& value : image.rgba) {
    const int coarse = (value + 4) & ~7;
    value = static_cast<std::uint8_t>(coarse > 255 ? 255 : coarse);
  }
  return image;
}

class Easel {
 public:
  Image draw(Picture picture) {
    Surroundings& around = picture.surroundings;
    around.background_top = around.background_bottom = {1, 1, 1, 1};
    around.show_grid = around.show_axes = false;
    renderer_.begin_frame();
    renderer_.draw(picture, {0, 0, width, height});
    return with_fewer_shades(renderer_.read_frame());
  }

 private:
  std::unique_ptr<GraphicsContext> context_ = make_offscreen_context(width, height, 1);
  Renderer renderer_{*context_};
};

bool shows_all(const Camera& camera, const Bounds& bounds) {
  constexpr double margin = 0.02;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 at = camera.project(
        {corner & 1 ? bounds.high.x : bounds.low.x, corner & 2 ? bounds.high.y : bounds.low.y,
         corner & 4 ? bounds.high.z : bounds.low.z},
        {width, height});
    if (at.x < margin * width || at.x > (1 - margin) * width || at.y < margin * height ||
        at.y > (1 - margin) * height)
      return false;
  }
  return true;
}

// As close to the step as shows all of what is around it.
Camera camera_for(const Story& story, const Picture& picture, std::optional<std::size_t> step) {
  const double aspect = double{width} / height;
  const Bounds all = picture.bounds();
  Camera whole;
  whole.look_at(all, aspect);
  if (!step) return whole;
  Camera close = whole;
  close.look_at(story.place_of(*step), aspect);
  for (double nearness = 1; nearness > 0; nearness -= 0.02)
    for (double aside = 0.6; aside >= 0; aside -= 0.05) {
      Camera camera = whole;
      camera.target = glm::mix(whole.target, close.target, aside);
      camera.distance = glm::mix(whole.distance, 0.6 * whole.distance, nearness);
      if (shows_all(camera, all)) return camera;
    }
  return whole;
}

// Those that would lie on another are moved down.
std::vector<StationSight::Name> names_in(const Picture& picture) {
  constexpr double line = 0.055, letter = 0.0145;
  std::vector<StationSight::Name> names;
  for (const Label& label : picture.labels) {
    const glm::dvec3 at = picture.camera.project(label.place, {width, height});
    if (at.z <= 0) continue;
    StationSight::Name name{at.x / width, at.y / height, label.text, label.colour};
    const double room = letter * static_cast<double>(label.text.size());
    name.x = std::clamp(name.x, 0.0, std::max(0.0, 0.97 - room));
    name.y = std::clamp(name.y, 0.08, 0.98);
    for (std::size_t i = 0; i < names.size(); ++i)
      if (std::abs(names[i].y - name.y) < line && names[i].x < name.x + room + 0.02 &&
          name.x < names[i].x + letter * static_cast<double>(names[i].text.size()) + 0.02) {
        name.y = names[i].y + 1.05 * line;
        i = static_cast<std::size_t>(-1);
      }
    names.push_back(std::move(name));
  }
  return names;
}

StationSight sight_of(const Station& station, Easel& easel) {
  const Story story = tell(sample_operands(station.sample));
  const std::optional<std::size_t> step = step_of(station, story);
  const auto [first, last] = story.range(station.phase);
  if (!step && first != last)
    throw std::logic_error("station \"" + station.title + "\" has no step that says \"" +
                           station.step + "\"");
  StoryView view;
  view.exploded = station.exploded;
  view.eight_way = station.eight_way;
  Picture picture = step ? story.picture(*step, view) : story.picture(station.phase, view);
  const bool whole = station.phase >= Phase::components;
  picture.camera = camera_for(story, picture, whole ? std::nullopt : step);
  StationSight sight;
  sight.png = png_of(easel.draw(picture));
  if (step) sight.step = story.step(*step);
  sight.legend = picture.legend;
  sight.names = names_in(picture);
  return sight;
}

}  // namespace

std::filesystem::path write_tour(const std::filesystem::path& folder) {
  Easel easel;
  std::vector<StationSight> sights;
  for (const Station& station : stations()) sights.push_back(sight_of(station, easel));
  std::filesystem::create_directories(folder);
  const std::filesystem::path path = folder / "index.html";
  write_whole(path, tour_page(stations(), sights));
  return path;
}

}  // namespace sectile::viewer
