// Ends the program in order when a person presses Ctrl-C.
#pragma once

namespace sectile::cli {

/// While one exists, SIGINT, SIGTERM and SIGHUP end the program at once and say that nothing was
/// written: there is nothing to clean up. Without one, signals do what they always do.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
};

/// While one exists within the life of an Interrupt, the first signal waits for the program to ask;
/// the second ends the program at once. For moments in which half a file would be left. Once it is
/// over, the files are in their places and the first signal finds nothing more to end.
class Deferral {
 public:
  Deferral();
  ~Deferral();
  Deferral(const Deferral&) = delete;
  Deferral& operator=(const Deferral&) = delete;

  /// Throws Cancelled if a signal came.
  void check() const;
};

/// Ends the program by the signal that asked for cancellation, so that shells see it.
[[noreturn]] void end_by_signal();

}  // namespace sectile::cli
