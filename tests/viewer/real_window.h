// The program itself in a window on the display of the test, driven by xdotool.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <string>

#include "scene/scene.h"

namespace sectile::viewer {

/// Waits for a condition; `again` is done at first and then every few seconds.
bool wait_for(const std::function<bool()>& condition, const std::function<void()>& again = {},
              std::chrono::seconds longest = std::chrono::seconds(120));
bool act(const std::string& what);  ///< of xdotool
/// The output of a command that finds something; empty if it does not.
std::string found_by(const std::string& command);

/// The program in a process of its own, which ends with this one.
class Program {
 public:
  Program(const std::filesystem::path& scene, const std::filesystem::path& data, int width,
          int height);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  bool is_running();
  int exit_code() const;
  void kill_at_once();  ///< as when the machine loses its power

 private:
  pid_t child_ = -1;
  bool ended_ = false;
  int status_ = 0;
};

/// Its window, with what people do there.
class RealWindow {
 public:
  RealWindow(const std::filesystem::path& scene, const std::filesystem::path& data, int width,
             int height)
      : scene_(scene), program_(scene, data, width, height) {}

  bool open();  ///< waits for it and gives it the focus
  void move(glm::dvec2 at);
  void click(glm::dvec2 at, bool shift = false);
  void double_click(glm::dvec2 at);
  void key(const std::string& name);  ///< "ctrl+m"
  void type(const std::string& text);
  void rest();  ///< until what was asked for is computed and drawn, as a person would
  /// Saves until this scene is in the file; false if it never is.
  bool has_scene(const Scene& wanted);
  Program& program() { return program_; }

 private:
  std::string place(glm::dvec2 at) const;
  std::filesystem::path scene_;
  Program program_;
  std::string window_;
};

}  // namespace sectile::viewer
