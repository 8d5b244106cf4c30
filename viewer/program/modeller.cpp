#include "program/modeller.h"

#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>

#include "app/app.h"
#include "render/window.h"

namespace sectile::viewer {
namespace {

// What is moved by the modeller itself comes to rest within as many frames.
constexpr int most_frames_of_screenshot = 60;
constexpr double seconds_per_frame_of_screenshot = 0.25;
// After an event the interface needs some frames until it has settled.
constexpr int frames_after_event = 3;

std::filesystem::path data_folder() {
  const char* data = std::getenv("XDG_DATA_HOME");
  if (data && *data) return std::filesystem::path(data) / "sectile";
  const char* home = std::getenv("HOME");
  if (home && *home) return std::filesystem::path(home) / ".local" / "share" / "sectile";
  return {};
}

void open_all(App& app, const Arguments& arguments) {
  if (!arguments.sample.empty()) app.open_sample(arguments.sample);
  if (!arguments.scene.empty()) app.open(arguments.scene);
  for (const auto& file : arguments.files) app.open(file);
}

void look(App& app, const Arguments& arguments) {
  // Steps count from one here; too large a number is the phase's last step.
  if (arguments.phase)
    app.show_step(*arguments.phase, arguments.step == 0 ? SIZE_MAX : arguments.step - 1);
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

Image modeller_screenshot(const Arguments& arguments) {
  const float scale = arguments.scale > 0 ? arguments.scale : 1;
  const auto context = make_offscreen_context(arguments.width, arguments.height, scale);
  AppOptions options;
  options.dark = arguments.dark;
  options.show_interface = arguments.interface;
  options.wait_for_results = true;
  App app(*context, options);
  open_all(app, arguments);
  const auto settle = [&] {
    for (int i = 0; i < most_frames_of_screenshot; ++i) {
      app.frame(Input{}, seconds_per_frame_of_screenshot);
      if (i >= frames_after_event && !app.needs_frame()) break;
    }
  };
  settle();
  look(app, arguments);
  settle();
  place_camera(app, arguments);
  settle();
  return app.screenshot();
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
    window.present();
    --frames_to_draw;
    if (!camera_placed && frames_to_draw == 0) place_camera(app, arguments), camera_placed = true;
  }
}

}  // namespace sectile::viewer
