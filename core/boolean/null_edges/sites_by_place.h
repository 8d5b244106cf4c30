// The sites of a plan, place by place.
#pragma once

#include <cstdint>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "boolean/null_edges/cut_plan.h"
#include "parallel/parallel.h"

namespace sectile {

/// All sites of one operand at one place, ascending by entity, are a place's sites.
class SitesByPlace {
 public:
  explicit SitesByPlace(const CutPlan& plan) : plan_(plan) {
    order_.reserve(plan.sites.size());
    for (const SiteId s : plan.sites.ids()) order_.push_back(s);
    parallel::sort(order_.begin(), order_.end(), [&](SiteId s, SiteId t) {
      return std::tuple(key(s), s) < std::tuple(key(t), t);
    });
    for (std::size_t i = 0; i < order_.size(); ++i) {
      if (i > 0 && key(order_[i]) == key(order_[i - 1])) continue;
      if (plan.sites[order_[i]].operand == Operand::a) ++of_a_;
      starts_.push_back(static_cast<std::uint32_t>(i));
    }
    starts_.push_back(static_cast<std::uint32_t>(order_.size()));
  }

  /// Those of A come first.
  std::size_t size() const { return starts_.size() - 1; }
  std::span<const SiteId> operator[](std::size_t i) const {
    return std::span(order_).subspan(starts_[i], starts_[i + 1] - starts_[i]);
  }

  /// Calls visit(sites) for all places of one operand.
  template <class Visit>
  void for_each(Operand operand, const Visit& visit) const {
    const std::size_t first = operand == Operand::a ? 0 : of_a_;
    const std::size_t last = operand == Operand::a ? of_a_ : size();
    for (std::size_t i = first; i < last; ++i) visit((*this)[i]);
  }

 private:
  std::pair<Operand, PlaceId> key(SiteId s) const {
    return {plan_.sites[s].operand, plan_.sites[s].place};
  }

  const CutPlan& plan_;
  std::vector<SiteId> order_;
  std::vector<std::uint32_t> starts_;  ///< of each place, and the end
  std::size_t of_a_ = 0;
};

}  // namespace sectile
