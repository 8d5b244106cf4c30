// A window of the desktop (GLFW): a context, and the source of input.
#pragma once

#include <string>

#include "events/input.h"
#include "render/current_context.h"

struct GLFWwindow;

namespace sectile::viewer {

/// One at a time. Throws std::runtime_error if there is no display or no OpenGL 3.3.
class Window final : public TurnTakingContext {
 public:
  /// The size is in units of the user interface; `scale` 0 takes that of the screen.
  Window(const std::string& title, int width, int height, float scale = 0);
  ~Window() override;
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  int width() const override;
  int height() const override;
  float scale() const override;
  void present() override;

  /// Waits for events until some arrived, wake() is called or the time is over; returns at once if
  /// it is zero.
  void wait(double seconds);
  /// The events since the last call. Closing is an event: the window stays until it is destroyed.
  Input take_input();
  bool is_minimised() const;
  /// Whether the window was uncovered or resized since the last call: it must be drawn again.
  bool take_damage();

  void set_title(const std::string& title);
  /// A value of ImGuiMouseCursor.
  void set_cursor(int cursor);
  /// Lets copy and paste of the current ImGui context use the desktop's clipboard.
  void connect_clipboard();

 protected:
  void bind() override;
  void unbind() override;
  Loader loader() const override;

 private:
  void destroy();

  GLFWwindow* window_ = nullptr;
  Input input_;
  bool damaged_ = true;
  float forced_scale_ = 0;
  int cursor_ = 0;
  void* cursors_[9] = {};  // GLFWcursor, by ImGuiMouseCursor
};

}  // namespace sectile::viewer
