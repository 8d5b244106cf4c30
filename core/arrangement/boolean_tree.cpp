#include "arrangement/boolean_tree.h"

#include <algorithm>
#include <mutex>
#include <span>

#include "parallel/parallel.h"
#include "search/hilbert.h"
#include "storage/solid_data.h"

namespace sectile::arrangement {
namespace {

class BooleanTree {
 public:
  BooleanTree(Operation operation, std::size_t solids, const Steering& steering)
      : operation_(operation), solids_(solids), steering_(steering) {}

  Solid run(std::span<const Solid> solids) {
    if (solids.size() == 1) return solids[0];
    const std::size_t half = solids.size() / 2;
    Solid first, second;
    parallel::invoke([&] { first = run(solids.first(half)); },
                     [&] { second = run(solids.subspan(half)); });
    steering_.check();
    if (operation_ == Operation::intersect && (first.is_empty() || second.is_empty()))
      return Solid();
    BooleanOptions options;
    options.cancel = steering_.cancel;
    if (solids.size() == solids_ && steering_.progress)  // the last one
      options.progress = [&](double done) { tell(double(solids_ - 2) + done); };
    Solid result;
    // A core that waits helps with this Boolean, not with another branch, which would take longer.
    parallel::isolate([&] { result = boolean(first, second, operation_, options); });
    note_step();
    return result;
  }

 private:
  void note_step() {
    if (!steering_.progress) return;
    const std::lock_guard lock(telling_);
    tell(double(++done_));
  }
  void tell(double booleans) const { steering_.progress(booleans / double(solids_ - 1)); }

  Operation operation_;
  std::size_t solids_;
  const Steering& steering_;
  std::mutex telling_;
  std::size_t done_ = 0;
};

// In the order of a curve that fills space.
std::vector<Solid> in_order(const std::vector<Solid>& solids) {
  std::vector<Box> boxes(solids.size());
  parallel::loop(0, boxes.size(),
                 [&](std::size_t i) { boxes[i] = solids[i].data()->slot_tree().bounds(); });
  Box all;
  for (const Box& b : boxes) all.add(b);
  const HilbertCurve curve(all);
  std::vector<std::pair<std::uint32_t, std::size_t>> keys;
  for (std::size_t i = 0; i < boxes.size(); ++i) keys.push_back({curve(boxes[i]), i});
  std::sort(keys.begin(), keys.end());
  std::vector<Solid> sorted;
  for (const auto& [key, i] : keys) sorted.push_back(solids[i]);
  return sorted;
}

}  // namespace

Solid combine(const std::vector<Solid>& solids, Operation operation, const Steering& steering) {
  const std::vector<Solid> sorted = solids.size() > 2 ? in_order(solids) : solids;
  Solid result;
  if (!sorted.empty()) result = BooleanTree(operation, sorted.size(), steering).run(sorted);
  steering.step(1);
  return result;
}

}  // namespace sectile::arrangement
