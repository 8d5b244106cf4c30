#include "interrupt.h"

#include <csignal>
#include <cstdlib>

#include "sectile/errors.h"

namespace sectile::cli {
namespace {

constexpr int signals[] = {SIGINT, SIGTERM, SIGHUP};

std::atomic<bool> requested_flag{false};
std::atomic<int> received{SIGINT};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

void handle(int signal) {
  received = signal;
  requested_flag = true;
}

}  // namespace

Interrupt::Interrupt() {
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

const std::atomic<bool>* Interrupt::requested() const {
  return &requested_flag;
}

void Interrupt::check() const {
  if (requested_flag) throw Cancelled();
}

void end_by_signal() {
  std::signal(received, SIG_DFL);
  std::raise(received);
  std::abort();
}

}  // namespace sectile::cli
