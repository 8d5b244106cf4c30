#include "progress.h"

#include <unistd.h>

#include <iostream>

namespace sectile::cli {

Progress::Progress(bool wanted) : wanted_(wanted && isatty(STDERR_FILENO)) {}

void Progress::stage(const std::string& what) {
  stage_ = what;
  show(stage_);
}

void Progress::fraction(double done) {
  show(stage_ + " " + std::to_string(static_cast<int>(100 * done)) + " %");
}

void Progress::show(const std::string& text) {
  if (!wanted_ || Clock::now() - start_ < std::chrono::seconds(1)) return;
  // Back to the start of the line, and erase what follows.
  std::cerr << '\r' << text << "\x1b[K" << std::flush;
  shown_ = true;
}

void Progress::clear() {
  if (shown_) std::cerr << "\r\x1b[K" << std::flush;
}

}  // namespace sectile::cli
