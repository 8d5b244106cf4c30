#include "interrupt.h"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>

#include "sectile/errors.h"

namespace sectile::cli {
namespace {

constexpr int signals[] = {SIGINT, SIGTERM, SIGHUP};

// What handlers may use: nothing of this is locked.
std::atomic<bool> requested{false}, deferred{false}, all_written{false}, at_terminal{false};
std::atomic<int> received{SIGINT};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

template <std::size_t size>
void say(const char (&text)[size]) {
  // If standard error takes no more, nobody reads it.
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text, size - 1);
}

void handle(int signal) {
  received = signal;
  requested = true;
  if (deferred || all_written) return;
  if (at_terminal) say("\r\x1b[K");  // over the progress
  say("sectile: interrupted; nothing was written\n");
  std::signal(signal, SIG_DFL);
  std::raise(signal);  // when the handler returns
}

}  // namespace

Interrupt::Interrupt() {
  at_terminal = isatty(STDERR_FILENO) != 0;
  struct sigaction action {};
  action.sa_handler = handle;
  action.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND);
  for (const int signal : signals) {
    struct sigaction old {};
    // A program started with a signal ignored (nohup) goes on ignoring it.
    if (sigaction(signal, nullptr, &old) == 0 && old.sa_handler != SIG_IGN)
      sigaction(signal, &action, nullptr);
  }
}

Interrupt::~Interrupt() {
  for (const int signal : signals) {
    struct sigaction old {};
    if (sigaction(signal, nullptr, &old) == 0 && old.sa_handler != SIG_IGN)
      std::signal(signal, SIG_DFL);
  }
}

Deferral::Deferral() {
  deferred = true;
}

Deferral::~Deferral() {
  all_written = true;
  deferred = false;
}

void Deferral::check() const {
  if (requested) throw Cancelled();
}

void end_by_signal() {
  std::signal(received, SIG_DFL);
  std::raise(received);
  std::abort();
}

}  // namespace sectile::cli
