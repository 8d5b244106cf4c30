// Tells a person at a terminal how far long work is.
#pragma once

#include <chrono>
#include <string>

namespace sectile::cli {

/// Says nothing in the first second, nothing if standard error is not a terminal, and leaves no
/// trace on the screen.
class Progress {
 public:
  explicit Progress(bool wanted);
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void stage(const std::string& what);
  /// From 0 to 1 within the stage.
  void fraction(double done);

 private:
  using Clock = std::chrono::steady_clock;

  void show(const std::string& text);
  void clear();

  bool wanted_;
  bool shown_ = false;
  std::string stage_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace sectile::cli
