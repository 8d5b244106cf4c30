#include "search/edge_fans.h"

#include <algorithm>

#include "numbers/threshold.h"

namespace sectile {
namespace {

constexpr std::size_t least_edges = threshold(24, 3);

}  // namespace

// An edge between two hubs belongs to the one of which there are more.
EdgeFans::EdgeFans(std::span<const Ends> edges) {
  if (edges.size() < least_edges) return;
  find_hubs(edges);
  if (hubs_.empty()) return;
  first_.assign(hubs_.size() + 1, 0);
  of_edge_.reserve(edges.size());
  for (const Ends& edge : edges) {
    of_edge_.push_back(fan_of(edge));
    if (of_edge_.back() != none) ++first_[of_edge_.back() + 1];
  }
  for (std::size_t fan = 0; fan < hubs_.size(); ++fan) first_[fan + 1] += first_[fan];
  members_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    const std::uint32_t fan = of_edge_[e];
    if (fan != none)
      members_[next[fan]++] = {e, edges[e][0] == hubs_[fan] ? edges[e][1] : edges[e][0]};
  }
}

void EdgeFans::find_hubs(std::span<const Ends> edges) {
  std::vector<std::uint32_t> ends;
  ends.reserve(2 * edges.size());
  for (const Ends& edge : edges)
    if (edge[0] != edge[1]) ends.insert(ends.end(), edge.begin(), edge.end());
  std::sort(ends.begin(), ends.end());
  for (auto first = ends.begin(), last = first; first != ends.end() && *first != none;
       first = last) {
    last = std::find_if(first, ends.end(), [&](std::uint32_t end) { return end != *first; });
    const auto count = static_cast<std::uint32_t>(last - first);
    if (count < least_edges) continue;
    hubs_.push_back(*first);
    counts_.push_back(count);
  }
}

std::uint32_t EdgeFans::around(std::uint32_t end) const {
  const auto at = std::lower_bound(hubs_.begin(), hubs_.end(), end);
  return at == hubs_.end() || *at != end ? none : static_cast<std::uint32_t>(at - hubs_.begin());
}

std::uint32_t EdgeFans::fan_of(const Ends& edge) const {
  if (edge[0] == edge[1]) return none;
  const std::uint32_t first = around(edge[0]), second = around(edge[1]);
  if (first == none || second == none) return std::min(first, second);
  return counts_[first] < counts_[second] ? second : first;
}

}  // namespace sectile
