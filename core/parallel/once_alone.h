// What is found out when it is first asked for, perhaps by several threads at a time.
#pragma once

#include <atomic>
#include <cstdint>

#include "parallel/parallel.h"

namespace sectile {

/// As std::once_flag, which makes a system call even where nobody waits: a Boolean has hundreds.
class OnceFlag {
 public:
  bool done() const { return state_.load(std::memory_order_acquire) == State::done; }

  /// Runs the body, unless another call has done so; waits while another call does. If the body
  /// throws, the next call runs it.
  template <class Body>
  void run(const Body& body) {
    if (enter()) leave_after(body, State::done);
  }

  /// Runs a body that looks at what is there before anything is found out, unless that is done; it
  /// is not done meanwhile. Returns whether the body was run.
  template <class Body>
  bool run_before(const Body& body) {
    if (!enter()) return false;
    leave_after(body, State::open);
    return true;
  }

 private:
  enum class State : std::uint8_t { open, running, done };

  // False if it is done.
  bool enter() {
    while (!done()) {
      State now = State::open;
      if (state_.compare_exchange_strong(now, State::running, std::memory_order_acquire))
        return true;
      if (now == State::running) state_.wait(State::running, std::memory_order_acquire);
    }
    return false;
  }
  template <class Body>
  void leave_after(const Body& body, State state) {
    try {
      body();
    } catch (...) {
      leave(State::open);
      throw;
    }
    leave(state);
  }
  void leave(State state) {
    state_.store(state, std::memory_order_release);
    state_.notify_all();
  }

  std::atomic<State> state_ = State::open;
};

/// Runs the body once, in isolation: a thread that waits for its own parallel loop within must not
/// take up an outer task that asks for the same, or it would wait for itself.
template <class Body>
void once_alone(OnceFlag& flag, const Body& body) {
  flag.run([&] { parallel::isolate(body); });
}

}  // namespace sectile
