#include "search/edge_chains.h"

#include <algorithm>

namespace sectile {
namespace {

class ChainFinder {
 public:
  explicit ChainFinder(std::span<const PointPair> edges) {
    for (const auto& [from, to] : edges) {
      steps_.push_back({from, to});
      steps_.push_back({to, from});
    }
    std::ranges::sort(steps_, {}, [](const Step& s) { return PointPair{s.from, s.to}; });
  }

  std::vector<std::vector<std::uint32_t>> run() {
    std::vector<std::vector<std::uint32_t>> chains;
    for (Step& first : steps_)
      if (!first.is_done && !leads_on(steps_from(first.from))) chains.push_back(follow(first));
    return chains;
  }

 private:
  struct Step {
    std::uint32_t from, to;
    bool is_done = false;
  };

  std::span<Step> steps_from(std::uint32_t point) {
    const auto [begin, end] =
        std::equal_range(steps_.begin(), steps_.end(), Step{point, 0},
                         [](const Step& a, const Step& b) { return a.from < b.from; });
    return {begin, end};
  }
  static bool leads_on(std::span<const Step> steps) { return steps.size() == 2; }

  std::vector<std::uint32_t> follow(Step& first) {
    std::vector<std::uint32_t> chain{first.from};
    for (Step* step = &first; step != nullptr;) {
      const std::uint32_t from = step->from, to = step->to;
      step->is_done = true;
      chain.push_back(to);
      const std::span<Step> steps = steps_from(to);
      step = nullptr;
      for (Step& next : steps)
        if (next.to == from)
          next.is_done = true;
        else if (leads_on(steps))
          step = &next;
    }
    return chain;
  }

  std::vector<Step> steps_;  // in both directions, by where they begin
};

}  // namespace

std::vector<std::vector<std::uint32_t>> edge_chains(std::span<const PointPair> edges) {
  return ChainFinder(edges).run();
}

}  // namespace sectile
