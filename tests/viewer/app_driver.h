// Drives the modeller without a window: synthetic events, a fixed time step, presses by widget
// name.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "app/app.h"
#include "app/session.h"
#include "app/widgets.h"
#include "render/graphics_context.h"

namespace sectile::viewer {

class AppDriver {
 public:
  explicit AppDriver(int width = 960, int height = 600, float scale = 1);
  AppDriver(const AppOptions& options, int width = 960, int height = 600, float scale = 1);

  /// Every frame waits for results; those are drawn with which what was done comes to rest.
  static AppOptions waiting();
  static AppOptions drawing();  ///< the same, and all frames are drawn

  App& app() { return *app_; }
  const Session& session() const { return app_->session(); }
  const Scene& scene() const { return app_->scene(); }

  void settle(int frames = 3);
  void move(glm::dvec2 to, bool shift = false, bool control = false);
  void click(glm::dvec2 at, bool shift = false);
  void drag(glm::dvec2 from, glm::dvec2 to, MouseButton button = MouseButton::left,
            bool control = false, bool shift = false);
  /// The first part of a drag; other events may come before let_go().
  void hold(glm::dvec2 from, glm::dvec2 to, bool control = false);
  void let_go(glm::dvec2 at);
  // The same in as few frames as it takes, without waiting for anything to come to rest.
  void short_key(Key key, bool control, bool shift);
  void short_click(glm::dvec2 at, bool shift);
  void short_drag(glm::dvec2 from, glm::dvec2 to, MouseButton button, bool control, bool shift);
  /// A drag and a key right after it, all of it between two frames.
  void drag_and_key(glm::dvec2 from, glm::dvec2 to, char letter, bool control);
  void double_click(glm::dvec2 at);
  /// The middle of a named widget.
  glm::dvec2 middle(const std::string& name) const;
  void press(const std::string& name) { click(middle(name)); }
  void key(Key key, bool control = false, bool shift = false);
  void key(char letter, bool control = false, bool shift = false) {
    key(static_cast<Key>(letter), control, shift);
  }
  void type(const std::string& text);
  /// Double clicks a field of numbers, types and ends with a key.
  void enter(const std::string& field, const std::string& text, Key end = Key::enter);
  void drop(const std::filesystem::path& file);
  // Names a file in the dialog that is open, ended by Enter or by the dialog's button.
  void enter_file(const std::filesystem::path& file);
  void accept_file(const std::filesystem::path& file);
  void add(const std::string& shape);  ///< by the tool bar
  /// Opens a sample and changes to the steps of its operation. Throws std::runtime_error if they
  /// are not there at once, so only where every frame waits for results.
  const Story& open_steps(const std::string& sample);

  /// Widgets that are cut off or lie on each other, in words; empty if all is well.
  std::string faults() const;

 private:
  void send(std::initializer_list<Event> events);
  void type_file(const std::filesystem::path& file);
  std::unique_ptr<GraphicsContext> context_;
  std::unique_ptr<App> app_;
};

}  // namespace sectile::viewer
