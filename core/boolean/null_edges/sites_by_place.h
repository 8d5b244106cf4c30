// The sites of a plan, place by place.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "boolean/null_edges/cut_plan.h"
#include "search/bucket_sort.h"

namespace sectile {

/// All sites of one operand at one place, ascending by entity, are a place's sites.
class SitesByPlace {
 public:
  SitesByPlace(const CutPlan& plan, std::size_t places) : places_(places) {
    order_.reserve(plan.sites.size());
    for (const SiteId s : plan.sites.ids()) order_.push_back(s);
    const auto number = [&](SiteId s) {
      const Site& site = plan.sites[s];
      return (site.operand == Operand::a ? 0 : places) + site.place.value();
    };
    starts_ = bucket_sort(order_, 2 * places, number, std::less<>());
  }

  /// Those of A come first; there may be places without a site.
  std::size_t size() const { return starts_.size() - 1; }
  std::span<const SiteId> operator[](std::size_t i) const {
    return std::span(order_).subspan(starts_[i], starts_[i + 1] - starts_[i]);
  }

  /// Calls visit(sites) for all places of one operand that have any.
  template <class Visit>
  void for_each(Operand operand, const Visit& visit) const {
    const std::size_t first = operand == Operand::a ? 0 : places_;
    for (std::size_t i = first; i < first + places_; ++i)
      if (const std::span<const SiteId> sites = (*this)[i]; !sites.empty()) visit(sites);
  }

 private:
  std::size_t places_;
  std::vector<SiteId> order_;
  std::vector<std::uint32_t> starts_;  ///< of each place, and the end
};

}  // namespace sectile
