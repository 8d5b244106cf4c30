// Stops work in order when a person presses Ctrl-C.
#pragma once

#include <atomic>

namespace sectile::cli {

/// While one exists, the first SIGINT, SIGTERM or SIGHUP only asks for cancellation; the second
/// ends the program at once. Outside, signals do what they always do: there is nothing to clean up.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  const std::atomic<bool>* requested() const;
  /// Throws Cancelled if a signal came.
  void check() const;
};

/// Ends the program by the signal that asked for cancellation, so that shells see it.
[[noreturn]] void end_by_signal();

}  // namespace sectile::cli
