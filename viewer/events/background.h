// Work away from the interface's thread, on one request after the other, of which the newest wins.
// Whatever ends wakes the window, so that nothing finished waits for the mouse to move.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "events/wake.h"

namespace sectile::viewer {

/// What a piece of work is told while it runs.
class WorkState {
 public:
  const std::atomic<bool>& cancelled() const { return cancelled_; }
  bool has_newer() const { return has_newer_; }  ///< another request waits for this one to end
  void cancel() { cancelled_ = true; }
  std::chrono::steady_clock::duration lasted() const {
    return std::chrono::steady_clock::now() - started_;
  }

 private:
  template <class Request, class Result>
  friend class Background;
  std::atomic<bool> cancelled_{false}, has_newer_{false};
  std::chrono::steady_clock::time_point started_;
};

template <class Request, class Result>
class Background {
 public:
  /// `work` runs in a thread of its own and must not throw. No result: what was there before stays.
  using Work = std::function<std::optional<Result>(Request, WorkState&)>;

  explicit Background(Work work) : work_(std::move(work)), thread_([this] { run(); }) {}
  /// Cancels what runs; a request that waits is dropped.
  ~Background() {
    {
      const std::lock_guard lock(mutex_);
      stops_ = true;
      state_.cancelled_ = true;
    }
    changed_.notify_all();
    thread_.join();
  }
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  /// Replaces a request that waits, and cancels what has been running for longer than `patience`.
  void request(Request request, std::chrono::steady_clock::duration patience = {}) {
    const std::lock_guard lock(mutex_);
    wanted_.emplace(std::move(request));
    state_.has_newer_ = true;
    if (is_running_ && state_.lasted() >= patience) state_.cancelled_ = true;
    changed_.notify_all();
  }
  /// Cancels what runs and drops what waits.
  void cancel() {
    const std::lock_guard lock(mutex_);
    wanted_.reset();
    state_.has_newer_ = false;
    if (is_running_) state_.cancelled_ = true;
    changed_.notify_all();
  }
  /// Forgets a result that nobody took.
  void drop_result() {
    const std::lock_guard lock(mutex_);
    result_.reset();
  }
  /// The newest result, once.
  std::optional<Result> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(result_, std::nullopt);
  }
  bool is_working() const {
    const std::lock_guard lock(mutex_);
    return wanted_.has_value() || is_running_;
  }
  /// Something runs or waits, or its result was not taken yet: the interface has to go on.
  bool is_busy() const {
    const std::lock_guard lock(mutex_);
    return wanted_.has_value() || is_running_ || result_.has_value();
  }
  void wait() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !wanted_ && !is_running_; });
  }

 private:
  void run() {
    std::unique_lock lock(mutex_);
    for (;;) {
      changed_.wait(lock, [this] { return stops_ || wanted_; });
      if (stops_) return;
      Request request = std::move(*wanted_);
      wanted_.reset();
      state_.has_newer_ = state_.cancelled_ = false;
      is_running_ = true;
      state_.started_ = std::chrono::steady_clock::now();
      lock.unlock();
      std::optional<Result> made = work_(std::move(request), state_);
      lock.lock();
      if (made) result_.swap(made);
      is_running_ = false;
      changed_.notify_all();
      lock.unlock();
      wake();
      made.reset();  // large results take their time to go
      lock.lock();
    }
  }

  const Work work_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Request> wanted_;
  std::optional<Result> result_;
  bool is_running_ = false, stops_ = false;
  WorkState state_;
  std::thread thread_;  // last: it starts when all else is there
};

}  // namespace sectile::viewer
