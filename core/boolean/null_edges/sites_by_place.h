// The sites of a plan, place by place.
#pragma once

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "boolean/null_edges/cut_plan.h"

namespace sectile {

class SitesByPlace {
 public:
  explicit SitesByPlace(const CutPlan& plan) : plan_(plan) {
    order_.reserve(plan.sites.size());
    for (const SiteId s : plan.sites.ids()) order_.push_back(s);
    std::stable_sort(order_.begin(), order_.end(),
                     [&](SiteId s, SiteId t) { return key(s) < key(t); });
  }

  /// Calls visit(the sites of one operand at one place, ascending by entity) for all of them.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (std::size_t from = 0, to; from < order_.size(); from = to) {
      for (to = from + 1; to < order_.size() && key(order_[to]) == key(order_[from]);) ++to;
      visit(std::span(order_).subspan(from, to - from));
    }
  }

 private:
  std::pair<Operand, PlaceId> key(SiteId s) const {
    return {plan_.sites[s].operand, plan_.sites[s].place};
  }

  const CutPlan& plan_;
  std::vector<SiteId> order_;
};

}  // namespace sectile
