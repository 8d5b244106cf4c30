#include "evaluation/evaluator.h"

#include <atomic>
#include <chrono>
#include <optional>

#include "evaluation/scene_computation.h"
#include "events/background.h"

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

namespace {

std::shared_ptr<const Evaluation> all_failed(const Scene& scene, std::uint64_t number,
                                             const std::string& error) {
  auto made = std::make_shared<Evaluation>();
  for (const NodeId id : scene.in_order()) made->nodes[id].error = error;
  made->request = number;
  return made;
}

}  // namespace

class Evaluator::Implementation {
 public:
  explicit Implementation(std::function<void(const Scene&)> before_work)
      : before_work_(std::move(before_work)), worker_([this](Wanted wanted, WorkState& state) {
          return compute(wanted.scene, wanted.number, state);
        }) {}

  std::uint64_t request(const Scene& scene) {
    worker_.request({scene, ++number_}, patience);
    return number_;
  }

  std::shared_ptr<const Evaluation> latest() {
    if (auto made = worker_.take()) latest_ = std::move(*made);
    return latest_;
  }

  bool is_busy() const { return worker_.is_busy(); }
  double progress() const { return progress_; }
  void cancel() { worker_.cancel(); }
  void wait() { worker_.wait(); }

 private:
  struct Wanted {
    Scene scene;
    std::uint64_t number = 0;
  };
  using Made = std::shared_ptr<const Evaluation>;

  std::optional<Made> compute(const Scene& scene, std::uint64_t number, WorkState& state) {
    progress_ = 0;
    std::optional<Made> made = attempt(scene, number, state);
    progress_ = 1;
    return made;
  }

  std::optional<Made> attempt(const Scene& scene, std::uint64_t number, WorkState& state) {
    const auto tell = [&](double done) {
      progress_ = done;
      if (state.has_newer() && state.lasted() > patience) state.cancel();
    };
    try {
      if (before_work_) before_work_(scene);
      auto made = std::make_shared<Evaluation>(computation_.run(scene, &state.cancelled(), tell));
      made->request = number;
      made->seconds = std::chrono::duration<double>(state.lasted()).count();
      return made;
    } catch (const Cancelled&) {
      return std::nullopt;
    } catch (const std::exception& error) {
      return all_failed(scene, number, error.what());
    }
  }

  const std::function<void(const Scene&)> before_work_;
  std::uint64_t number_ = 0;
  Made latest_;
  std::atomic<double> progress_{1};
  SceneComputation computation_;  // the worker's
  Background<Wanted, Made> worker_;
};

Evaluator::Evaluator(std::function<void(const Scene&)> before_work)
    : implementation_(std::make_unique<Implementation>(std::move(before_work))) {}
Evaluator::~Evaluator() = default;

std::uint64_t Evaluator::request(const Scene& scene) {
  return implementation_->request(scene);
}
std::shared_ptr<const Evaluation> Evaluator::latest() {
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
