#include "program/modeller.h"

#include <imgui.h>

#include <algorithm>
#include <chrono>

#include "app/app.h"
#include "app/session.h"
#include "program/phase_picture.h"
#include "program/solid_file.h"
#include "render/window.h"
#include "scene/recovery.h"
#include "scene/scene_file.h"

namespace sectile::viewer {
namespace {

// What is moved by the modeller itself comes to rest within as many frames.
constexpr int most_frames_of_screenshot = 60;
constexpr double seconds_per_frame_of_screenshot = 0.25;
// After an event the interface needs some frames until it has settled.
constexpr int frames_after_event = 3;

void open_all(App& app, const Arguments& arguments) {
  if (!arguments.sample.empty()) app.open_sample(arguments.sample);
  if (!arguments.scene.empty()) app.open(arguments.scene);
  for (const auto& file : arguments.files) app.open(file);
}

// For a picture: what cannot be read is an error, with the exit code of its kind.
void open_all_or_throw(App& app, const Arguments& arguments) {
  if (!arguments.sample.empty()) app.open_sample(arguments.sample);
  if (!arguments.scene.empty()) app.start(read_scene(arguments.scene).scene, arguments.scene);
  for (const std::filesystem::path& file : arguments.files) {
    if (is_scene_file(file)) {
      app.start(read_scene(file).scene, file);
    } else {
      const std::vector<MeshPart> parts = read_parts(file).parts;
      for (const MeshPart& part : parts) solid_of_file(file, *part.mesh);
      app.add(file, parts);
    }
  }
}

void look(App& app, const Arguments& arguments) {
  // Steps count from one here; none given is the phase's last step.
  if (arguments.phase)
    app.show_step(*arguments.phase, arguments.step == 0 ? SIZE_MAX : arguments.step - 1);
}

// Once its story is told: throws if there is none, or no such step.
void check_step(const App& app, const Arguments& arguments) {
  if (!arguments.phase) return;
  const Story* story = app.session().results.player.story();
  if (!story)
    throw std::invalid_argument("--phase: there are no steps to show: " +
                                app.session().why_no_story());
  check_step_of(*story, *arguments.phase, arguments.step);
}

void place_camera(App& app, const Arguments& arguments) {
  if (!arguments.camera) return;
  // The modeller looks at all there is when it opened something: that is the target.
  Camera camera = arguments.camera->applied_to(app.camera(), Bounds(), 1);
  app.set_camera(camera);
}

double seconds_since(std::chrono::steady_clock::time_point& last) {
  const auto now = std::chrono::steady_clock::now();
  const std::chrono::duration<double> passed = now - last;
  last = now;
  return std::min(passed.count(), 0.25);
}

}  // namespace

void with_still_modeller(const Arguments& arguments, const std::function<void(App&)>& use) {
  const float scale = arguments.scale > 0 ? arguments.scale : 1;
  const auto context = make_offscreen_context(arguments.width, arguments.height, scale);
  AppOptions options;
  options.dark = arguments.dark;
  options.show_interface = arguments.interface;
  options.wait_for_results = options.draw_on_request = true;
  App app(*context, options);
  open_all_or_throw(app, arguments);
  const auto settle = [&] {
    for (int i = 0; i < most_frames_of_screenshot; ++i) {
      app.frame(Input{}, seconds_per_frame_of_screenshot);
      if (i >= frames_after_event && !app.needs_frame()) break;
    }
  };
  settle();
  look(app, arguments);
  settle();
  check_step(app, arguments);
  place_camera(app, arguments);
  settle();
  use(app);
}

Image modeller_screenshot(const Arguments& arguments) {
  Image image;
  with_still_modeller(arguments, [&](App& app) { image = app.screenshot(); });
  return image;
}

void run_in_window(const Arguments& arguments, Window& window) {
  AppOptions options;
  options.data_folder = data_folder();
  options.dark = arguments.dark;
  options.show_interface = arguments.interface;
  App app(window, options);
  window.connect_clipboard();
  open_all(app, arguments);
  look(app, arguments);
  bool camera_placed = false;
  int frames_to_draw = frames_after_event;
  std::string title;
  auto last = std::chrono::steady_clock::now();
  while (!app.wants_to_close()) {
    window.wait(frames_to_draw > 0 ? 0 : app.time_to_next_frame());
    const Input input = window.take_input();
    if (window.take_damage() || !input.events.empty()) frames_to_draw = frames_after_event;
    // A blinking cursor in a text field.
    if (ImGui::GetIO().WantTextInput || app.needs_frame())
      frames_to_draw = std::max(frames_to_draw, 1);
    if (frames_to_draw == 0) continue;
    if (window.is_minimised()) {
      window.wait(0.1);
      if (input.events.empty()) continue;
    }
    app.frame(input, seconds_since(last));
    window.set_cursor(ImGui::GetMouseCursor());
    if (app.title() != title) window.set_title(title = app.title());
    window.present();
    --frames_to_draw;
    if (!camera_placed && frames_to_draw == 0) place_camera(app, arguments), camera_placed = true;
  }
}

}  // namespace sectile::viewer
