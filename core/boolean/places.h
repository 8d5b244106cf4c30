// Walks over the sites place by place.
#pragma once

#include <algorithm>
#include <numeric>
#include <span>

#include "boolean/workspace.h"

namespace sectile {

/// Calls visit(indices of the sites of one solid at one place) for all of them.
template <class Visit>
void for_each_place(const Workspace& w, const Visit& visit) {
  std::vector<std::uint32_t> order(w.sites.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t i) { return std::pair(w.sites[i].solid, w.sites[i].place); };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t i, std::uint32_t j) { return key(i) < key(j); });
  for (std::size_t from = 0, to; from < order.size(); from = to) {
    for (to = from + 1; to < order.size() && key(order[to]) == key(order[from]);) ++to;
    visit(std::span<const std::uint32_t>(order).subspan(from, to - from));
  }
}

}  // namespace sectile
