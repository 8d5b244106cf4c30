#include "render/window_events.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <map>
#include <memory>
#include <optional>

namespace sectile::viewer {
namespace {

struct Collector {
  Input* input = nullptr;
  bool* damaged = nullptr;
  const GraphicsContext* context = nullptr;
};

// GLFW keeps one pointer for each window, but there is only one window.
Collector collector;

void add(const Event& event) {
  collector.input->events.push_back(event);
}

void set_modifiers(Event& event, int mods) {
  event.shift = mods & GLFW_MOD_SHIFT;
  event.control = mods & (GLFW_MOD_CONTROL | GLFW_MOD_SUPER);
  event.alt = mods & GLFW_MOD_ALT;
}

// For events that GLFW reports without modifiers.
int modifiers_now(GLFWwindow* window) {
  const auto held = [&](int left, int right) {
    return glfwGetKey(window, left) == GLFW_PRESS || glfwGetKey(window, right) == GLFW_PRESS;
  };
  return (held(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT) ? GLFW_MOD_SHIFT : 0) |
         (held(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL) ? GLFW_MOD_CONTROL : 0) |
         (held(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT) ? GLFW_MOD_ALT : 0);
}

// Window coordinates may be pixels or not; units of the interface come from pixels.
glm::dvec2 in_units(GLFWwindow* window, double x, double y) {
  int width = 1, height = 1;
  glfwGetWindowSize(window, &width, &height);
  const double scale = static_cast<double>(collector.context->scale());
  return {x * collector.context->width() / (width * scale),
          y * collector.context->height() / (height * scale)};
}

std::optional<Key> key_of(int key) {
  static const std::map<int, Key> special = {{GLFW_KEY_ESCAPE, Key::escape},
                                             {GLFW_KEY_ENTER, Key::enter},
                                             {GLFW_KEY_KP_ENTER, Key::enter},
                                             {GLFW_KEY_TAB, Key::tab},
                                             {GLFW_KEY_BACKSPACE, Key::backspace},
                                             {GLFW_KEY_DELETE, Key::del},
                                             {GLFW_KEY_INSERT, Key::insert},
                                             {GLFW_KEY_LEFT, Key::left},
                                             {GLFW_KEY_RIGHT, Key::right},
                                             {GLFW_KEY_UP, Key::up},
                                             {GLFW_KEY_DOWN, Key::down},
                                             {GLFW_KEY_PAGE_UP, Key::page_up},
                                             {GLFW_KEY_PAGE_DOWN, Key::page_down},
                                             {GLFW_KEY_HOME, Key::home},
                                             {GLFW_KEY_END, Key::end}};
  const auto found = special.find(key);
  if (found != special.end()) return found->second;
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12)
    return static_cast<Key>(static_cast<int>(Key::f1) + key - GLFW_KEY_F1);
  if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9)
    return static_cast<Key>('0' + key - GLFW_KEY_KP_0);
  if (key == GLFW_KEY_KP_ADD) return static_cast<Key>('+');
  if (key == GLFW_KEY_KP_SUBTRACT) return static_cast<Key>('-');
  return std::nullopt;
}

// Letters by what is printed on them: shortcuts go by the name of the key, not by its place.
std::optional<Key> printed_on(int key, int scancode) {
  if (key < GLFW_KEY_SPACE || key > GLFW_KEY_GRAVE_ACCENT) return std::nullopt;
  const char* name = glfwGetKeyName(key, scancode);
  if (!name || !name[0] || name[1]) return static_cast<Key>(key);
  const char c = name[0];
  return static_cast<Key>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
}

std::string utf8(unsigned codepoint) {
  std::string text;
  const auto put = [&](unsigned byte) { text.push_back(static_cast<char>(byte)); };
  if (codepoint < 0x80) {
    put(codepoint);
  } else if (codepoint < 0x800) {
    put(0xc0 | codepoint >> 6), put(0x80 | (codepoint & 63));
  } else if (codepoint < 0x10000) {
    put(0xe0 | codepoint >> 12), put(0x80 | (codepoint >> 6 & 63)), put(0x80 | (codepoint & 63));
  } else {
    put(0xf0 | codepoint >> 18), put(0x80 | (codepoint >> 12 & 63));
    put(0x80 | (codepoint >> 6 & 63)), put(0x80 | (codepoint & 63));
  }
  return text;
}

void on_move(GLFWwindow* window, double x, double y) {
  Event event;
  event.kind = Event::Kind::mouse_move;
  event.position = in_units(window, x, y);
  set_modifiers(event, modifiers_now(window));
  add(event);
}

void on_button(GLFWwindow* window, int button, int action, int mods) {
  if (button > GLFW_MOUSE_BUTTON_MIDDLE) return;
  Event event;
  event.kind = action == GLFW_PRESS ? Event::Kind::mouse_down : Event::Kind::mouse_up;
  double x = 0, y = 0;
  glfwGetCursorPos(window, &x, &y);
  event.position = in_units(window, x, y);
  event.button = button == GLFW_MOUSE_BUTTON_LEFT    ? MouseButton::left
                 : button == GLFW_MOUSE_BUTTON_RIGHT ? MouseButton::right
                                                     : MouseButton::middle;
  set_modifiers(event, mods);
  add(event);
}

void on_scroll(GLFWwindow* window, double x, double y) {
  Event event;
  event.kind = Event::Kind::scroll;
  event.scroll = {x, y};
  double at_x = 0, at_y = 0;
  glfwGetCursorPos(window, &at_x, &at_y);
  event.position = in_units(window, at_x, at_y);
  set_modifiers(event, modifiers_now(window));
  add(event);
}

void on_key(GLFWwindow*, int key, int scancode, int action, int mods) {
  std::optional<Key> named = key_of(key);
  if (!named) named = printed_on(key, scancode);
  if (!named) return;
  Event event;
  // A key that repeats is pressed again.
  event.kind = action == GLFW_RELEASE ? Event::Kind::key_up : Event::Kind::key_down;
  event.key = *named;
  set_modifiers(event, mods);
  add(event);
}

void on_text(GLFWwindow*, unsigned codepoint) {
  Event event;
  event.kind = Event::Kind::text;
  event.text = utf8(codepoint);
  add(event);
}

void on_drop(GLFWwindow* window, int count, const char** paths) {
  Event event;
  event.kind = Event::Kind::drop;
  double x = 0, y = 0;
  glfwGetCursorPos(window, &x, &y);
  event.position = in_units(window, x, y);
  for (int i = 0; i < count; ++i) event.files.emplace_back(paths[i]);
  add(event);
}

void on_focus(GLFWwindow*, int focused) {
  if (focused) return;
  Event event;
  event.kind = Event::Kind::focus_lost;
  add(event);
}

void on_close(GLFWwindow* window) {
  glfwSetWindowShouldClose(window, GLFW_FALSE);
  Event event;
  event.kind = Event::Kind::close;
  add(event);
}

}  // namespace

void collect_events(GLFWwindow* window, Input& input, bool& damaged,
                    const GraphicsContext& context) {
  collector = {&input, &damaged, &context};
  glfwSetWindowRefreshCallback(window, [](GLFWwindow*) { *collector.damaged = true; });
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow*, int, int) { *collector.damaged = true; });
  glfwSetWindowContentScaleCallback(window,
                                    [](GLFWwindow*, float, float) { *collector.damaged = true; });
  glfwSetCursorPosCallback(window, on_move);
  glfwSetMouseButtonCallback(window, on_button);
  glfwSetScrollCallback(window, on_scroll);
  glfwSetKeyCallback(window, on_key);
  glfwSetCharCallback(window, on_text);
  glfwSetDropCallback(window, on_drop);
  glfwSetWindowFocusCallback(window, on_focus);
  glfwSetWindowCloseCallback(window, on_close);
}

}  // namespace sectile::viewer
