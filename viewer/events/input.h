// Input events as plain data, so that a window and a test can both make them. Positions in UI units
// from the top left of the window.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace sectile::viewer {

enum class MouseButton : int { left, right, middle };

/// Printable keys are their upper-case ASCII code; the others follow.
enum class Key : int {
  space = 32,
  escape = 256,
  enter,
  tab,
  backspace,
  del,
  insert,
  left,
  right,
  up,
  down,
  page_up,
  page_down,
  home,
  end,
  f1,
  f2,
  f3,
  f4,
  f5,
  f6,
  f7,
  f8,
  f9,
  f10,
  f11,
  f12
};

struct Event {
  enum class Kind {
    mouse_move,
    mouse_down,
    mouse_up,
    scroll,
    key_down,
    key_up,
    text,
    drop,
    focus_lost,
    close
  };
  Kind kind = Kind::mouse_move;
  glm::dvec2 position{0};  ///< mouse_move
  MouseButton button = MouseButton::left;
  glm::dvec2 scroll{0};
  Key key = Key::space;
  bool shift = false, control = false, alt = false;
  std::string text;  ///< UTF-8
  std::vector<std::filesystem::path> files;
};

/// Events since the last frame in the order in which they arrived.
struct Input {
  std::vector<Event> events;
};

}  // namespace sectile::viewer
