#include "evaluation/evaluator.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "evaluation/scene_computation.h"

namespace sectile::viewer {

namespace {

using Clock = std::chrono::steady_clock;

// How long a computation may go on although a newer scene waits.
constexpr std::chrono::milliseconds patience{500};

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

const Evaluation::Entry* Evaluation::find(NodeId id) const {
  const auto found = nodes.find(id);
  return found == nodes.end() ? nullptr : &found->second;
}

Bounds bounds_of(const Evaluation& evaluation, const Scene& scene, const std::vector<NodeId>& ids) {
  Bounds made;
  for (const NodeId id : ids) {
    const Evaluation::Entry* entry = evaluation.find(id);
    const bool has_own = entry && !entry->bounds.is_empty();
    if (has_own) made.add(entry->bounds);
    if (const Node* node = scene.find(id); node && !has_own)
      made.add(bounds_of(evaluation, scene, node->children));
  }
  return made;
}

class Evaluator::Implementation {
 public:
  explicit Implementation(std::function<void(const Scene&)> before_work)
      : before_work_(std::move(before_work)), thread_([this] { work(); }) {}

  ~Implementation() {
    {
      const std::lock_guard lock(mutex_);
      stops_ = true;
      cancel_ = true;
    }
    changed_.notify_all();
    thread_.join();
  }

  std::uint64_t request(const Scene& scene) {
    const std::lock_guard lock(mutex_);
    wanted_ = scene;
    has_newer_ = true;
    if (is_running_ && Clock::now() - started_ > patience) cancel_ = true;
    changed_.notify_all();
    return ++number_;
  }

  std::shared_ptr<const Evaluation> latest() const {
    const std::lock_guard lock(mutex_);
    return latest_;
  }

  bool is_busy() const {
    const std::lock_guard lock(mutex_);
    return wanted_.has_value() || is_running_;
  }

  double progress() const { return progress_; }

  void cancel() {
    const std::lock_guard lock(mutex_);
    wanted_.reset();
    has_newer_ = false;
    if (is_running_) cancel_ = true;
    changed_.notify_all();
  }

  void wait() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !wanted_ && !is_running_; });
  }

 private:
  void work() {
    std::unique_lock lock(mutex_);
    for (;;) {
      changed_.wait(lock, [this] { return stops_ || wanted_; });
      if (stops_) return;
      const Scene scene = std::move(*wanted_);
      wanted_.reset();
      const std::uint64_t number = number_;
      has_newer_ = cancel_ = false;
      is_running_ = true;
      started_ = Clock::now();
      progress_ = 0;
      lock.unlock();
      std::shared_ptr<const Evaluation> made = compute(scene, number);
      lock.lock();
      if (made) latest_.swap(made);
      is_running_ = false;
      progress_ = 1;
      changed_.notify_all();
      lock.unlock();
      made.reset();  // large solids take their time to go
      lock.lock();
    }
  }

  std::shared_ptr<const Evaluation> compute(const Scene& scene, std::uint64_t number) {
    const auto tell = [this](double done) {
      progress_ = done;
      if (has_newer_ && Clock::now() - started_ > patience) cancel_ = true;
    };
    try {
      if (before_work_) before_work_(scene);
      auto made = std::make_shared<Evaluation>(computation_.run(scene, &cancel_, tell));
      made->request = number;
      made->seconds = seconds_since(started_);
      return made;
    } catch (const Cancelled&) {
      return nullptr;
    } catch (const std::exception& error) {
      return all_failed(scene, number, error.what());
    }
  }

  static std::shared_ptr<const Evaluation> all_failed(const Scene& scene, std::uint64_t number,
                                                      const std::string& error) {
    auto made = std::make_shared<Evaluation>();
    for (const NodeId id : scene.in_order()) made->nodes[id].error = error;
    made->request = number;
    return made;
  }

  const std::function<void(const Scene&)> before_work_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Scene> wanted_;
  std::shared_ptr<const Evaluation> latest_;
  std::uint64_t number_ = 0;
  bool is_running_ = false, stops_ = false;
  Clock::time_point started_;  // written by the worker under the lock, read by it without
  std::atomic<bool> has_newer_{false}, cancel_{false};
  std::atomic<double> progress_{1};
  SceneComputation computation_;  // the worker's
  std::thread thread_;            // last: it starts when all else is there
};

Evaluator::Evaluator(std::function<void(const Scene&)> before_work)
    : implementation_(std::make_unique<Implementation>(std::move(before_work))) {}
Evaluator::~Evaluator() = default;

std::uint64_t Evaluator::request(const Scene& scene) {
  return implementation_->request(scene);
}
std::shared_ptr<const Evaluation> Evaluator::latest() const {
  return implementation_->latest();
}
bool Evaluator::is_busy() const {
  return implementation_->is_busy();
}
double Evaluator::progress() const {
  return implementation_->progress();
}
void Evaluator::cancel() {
  implementation_->cancel();
}
void Evaluator::wait() {
  implementation_->wait();
}

Evaluation evaluate(const Scene& scene) {
  const auto start = Clock::now();
  Evaluation made = SceneComputation().run(scene, nullptr, {});
  made.seconds = seconds_since(start);
  return made;
}

}  // namespace sectile::viewer
