#include "render/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "events/wake.h"
#include "render/window_events.h"

namespace sectile::viewer {
namespace {

std::string last_error() {
  const char* message = nullptr;
  glfwGetError(&message);
  return message ? message : "no reason given";
}

int shape_of(int cursor) {
  switch (cursor) {
    case ImGuiMouseCursor_TextInput:
      return GLFW_IBEAM_CURSOR;
    case ImGuiMouseCursor_ResizeAll:
      return GLFW_CROSSHAIR_CURSOR;
    case ImGuiMouseCursor_ResizeNS:
      return GLFW_VRESIZE_CURSOR;
    case ImGuiMouseCursor_ResizeEW:
      return GLFW_HRESIZE_CURSOR;
    case ImGuiMouseCursor_Hand:
      return GLFW_HAND_CURSOR;
    default:
      return GLFW_ARROW_CURSOR;
  }
}

}  // namespace

Window::Window(const std::string& title, int width, int height, float scale)
    : forced_scale_(scale) {
  if (!glfwInit()) throw std::runtime_error("No display: " + last_error());
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, scale > 0 ? GLFW_FALSE : GLFW_TRUE);
  const float factor = scale > 0 ? scale : 1;
  window_ = glfwCreateWindow(static_cast<int>(std::lround(static_cast<float>(width) * factor)),
                             static_cast<int>(std::lround(static_cast<float>(height) * factor)),
                             title.c_str(), nullptr, nullptr);
  if (!window_) {
    const std::string reason = last_error();
    glfwTerminate();
    throw std::runtime_error("No window with OpenGL 3.3: " + reason);
  }
  glfwSetWindowSizeLimits(window_, 640, 400, GLFW_DONT_CARE, GLFW_DONT_CARE);
  try {
    make_current();
  } catch (...) {
    destroy();
    throw;
  }
  glfwSwapInterval(1);
  collect_events(window_, input_, damaged_, *this);
  set_wake(glfwPostEmptyEvent);
}

Window::~Window() {
  retire();
  destroy();
}

void Window::destroy() {
  set_wake(nullptr);
  for (void* cursor : cursors_)
    if (cursor) glfwDestroyCursor(static_cast<GLFWcursor*>(cursor));
  glfwDestroyWindow(window_);
  glfwTerminate();
}

int Window::width() const {
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  return width;
}

int Window::height() const {
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  return height;
}

float Window::scale() const {
  if (forced_scale_ > 0) return forced_scale_;
  float x = 1, y = 1;
  glfwGetWindowContentScale(window_, &x, &y);
  return x > 0 ? x : 1;
}

void Window::present() {
  glfwSwapBuffers(window_);
}

void Window::wait(double seconds) {
  if (seconds > 0 && input_.events.empty())
    glfwWaitEventsTimeout(seconds);
  else
    glfwPollEvents();
}

Input Window::take_input() {
  return std::exchange(input_, Input{});
}

bool Window::take_damage() {
  return std::exchange(damaged_, false);
}

bool Window::is_minimised() const {
  return width() == 0 || height() == 0;
}

void Window::set_title(const std::string& title) {
  glfwSetWindowTitle(window_, title.c_str());
}

void Window::set_cursor(int cursor) {
  if (cursor == cursor_) return;
  cursor_ = cursor;
  if (cursor == ImGuiMouseCursor_None) {
    glfwSetInputMode(window_, GLFW_CURSOR, GLFW_CURSOR_HIDDEN);
    return;
  }
  glfwSetInputMode(window_, GLFW_CURSOR, GLFW_CURSOR_NORMAL);
  if (cursor < 0 || cursor >= static_cast<int>(std::size(cursors_))) return;
  void*& made = cursors_[cursor];
  if (!made) made = glfwCreateStandardCursor(shape_of(cursor));
  glfwSetCursor(window_, static_cast<GLFWcursor*>(made));
}

void Window::connect_clipboard() {
  ImGuiIO& io = ImGui::GetIO();
  io.ClipboardUserData = window_;
  io.SetClipboardTextFn = [](void* window, const char* text) {
    glfwSetClipboardString(static_cast<GLFWwindow*>(window), text);
  };
  io.GetClipboardTextFn = [](void* window) {
    return glfwGetClipboardString(static_cast<GLFWwindow*>(window));
  };
}

void Window::bind() {
  glfwMakeContextCurrent(window_);
}

void Window::unbind() {
  glfwMakeContextCurrent(nullptr);
}

TurnTakingContext::Loader Window::loader() const {
  return glfwGetProcAddress;
}

}  // namespace sectile::viewer
