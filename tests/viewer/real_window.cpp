#include "viewer/real_window.h"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "scene/scene_file.h"

namespace sectile::viewer {
namespace {

// How fast a person presses one thing after another.
constexpr std::chrono::milliseconds between_acts{120}, at_rest{1200};

}  // namespace

bool wait_for(const std::function<bool()>& condition, const std::function<void()>& again,
              std::chrono::seconds longest) {
  const auto start = std::chrono::steady_clock::now();
  auto tried = start - longest;
  while (!condition()) {
    const auto now = std::chrono::steady_clock::now();
    if (now - start > longest) return false;
    if (again && now - tried > std::chrono::seconds(8)) again(), tried = now;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return true;
}

bool act(const std::string& what) {
  return std::system(("xdotool " + what).c_str()) == 0;
}

std::string found_by(const std::string& command) {
  std::string text;
  FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) return text;
  for (int c = fgetc(pipe); c != EOF && c != '\n'; c = fgetc(pipe)) text += static_cast<char>(c);
  return pclose(pipe) == 0 ? text : std::string();
}

Program::Program(const std::filesystem::path& scene, const std::filesystem::path& data, int width,
                 int height) {
  const std::string size = std::to_string(width) + "x" + std::to_string(height);
  child_ = fork();
  if (child_ != 0) return;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  setenv("XDG_DATA_HOME", data.c_str(), 1);
  execl(SECTILE_VIEWER_PROGRAM, SECTILE_VIEWER_PROGRAM, "--scene", scene.c_str(), "--size",
        size.c_str(), "--scale", "1", nullptr);
  _exit(127);
}

Program::~Program() {
  if (is_running()) kill_at_once();
}

bool Program::is_running() {
  if (!ended_) ended_ = waitpid(child_, &status_, WNOHANG) == child_;
  return !ended_;
}

int Program::exit_code() const {
  return ended_ && WIFEXITED(status_) ? WEXITSTATUS(status_) : -1;
}

void Program::kill_at_once() {
  kill(child_, SIGKILL);
  waitpid(child_, &status_, 0);
  ended_ = true;
}

bool RealWindow::open() {
  const std::string search = "xdotool search --onlyvisible --name 'Sectile$' 2>/dev/null";
  if (!wait_for([&] { return !(window_ = found_by(search)).empty(); })) return false;
  return wait_for([&] { return found_by("xdotool getwindowfocus") == window_; },
                  [&] { act("windowfocus " + window_); });
}

std::string RealWindow::place(glm::dvec2 at) const {
  return "mousemove --window " + window_ + " " + std::to_string(std::lround(at.x)) + " " +
         std::to_string(std::lround(at.y));
}

void RealWindow::move(glm::dvec2 at) {
  act(place(at));
  std::this_thread::sleep_for(between_acts);
}

void RealWindow::click(glm::dvec2 at, bool shift) {
  move(at);
  act(shift ? "keydown shift click 1 keyup shift" : "click 1");
  // Two clicks in one place are not to be a double click.
  std::this_thread::sleep_for(4 * between_acts);
}

void RealWindow::double_click(glm::dvec2 at) {
  move(at);
  act("click --repeat 2 --delay 60 1");
  std::this_thread::sleep_for(2 * between_acts);
}

void RealWindow::key(const std::string& name) {
  act("key " + name);
  std::this_thread::sleep_for(between_acts);
}

void RealWindow::type(const std::string& text) {
  act("type --delay 30 '" + text + "'");
  std::this_thread::sleep_for(between_acts);
}

void RealWindow::rest() {
  std::this_thread::sleep_for(at_rest);
}

bool RealWindow::has_scene(const Scene& wanted) {
  return wait_for([&] { return read_scene(scene_).scene == wanted; }, [] { act("key ctrl+s"); },
                  std::chrono::seconds(30));
}

}  // namespace sectile::viewer
