#include "selftest/rim_sweep.h"

#include <algorithm>

#include "geometry/axes.h"

namespace sectile {

// The sign of q - p in the order of u, then v.
Sign RimSweep::before(PointId p, PointId q) const {
  const Sign s = kernel_.compare(p, q, u_);
  return s != Sign::zero ? s : kernel_.compare(p, q, v_);
}

bool RimSweep::read(std::span<const RimEdge> rim, bool behind) {
  edges_.clear();
  starts_.clear();
  ends_.clear();
  front_.clear();
  for (const RimEdge& e : rim) {
    const Sign s = before(e.from, e.to);
    if (s == Sign::zero) return false;
    const bool rightwards = s == Sign::positive;
    const auto number = static_cast<std::uint32_t>(edges_.size());
    edges_.push_back(rightwards ? Edge{e.from, e.to, !behind} : Edge{e.to, e.from, behind});
    starts_.push_back({edges_.back().left, number});
    ends_.push_back({edges_.back().right, number});
  }
  const auto by_place = [&](const Event& a, const Event& b) {
    if (a.point == b.point) return a.edge < b.edge;
    const Sign s = before(a.point, b.point);
    return s != Sign::zero ? s == Sign::positive : a.point < b.point;
  };
  std::sort(starts_.begin(), starts_.end(), by_place);
  std::sort(ends_.begin(), ends_.end(), by_place);
  return true;
}

bool RimSweep::winds_once(std::span<const RimEdge> rim, int axis, bool behind) {
  axis_ = axis;
  u_ = next_axis(axis);
  v_ = next_next_axis(axis);
  if (!read(rim, behind)) return false;
  std::size_t s = 0, e = 0;
  while (e < ends_.size()) {
    // The rim is a sum of closed paths: something ends wherever something starts, or starts anew.
    PointId point = ends_[e].point;
    if (s < starts_.size() && starts_[s].point != point &&
        before(starts_[s].point, point) != Sign::negative)
      point = starts_[s].point;
    std::size_t next_s = s, next_e = e;
    while (next_s < starts_.size() && starts_[next_s].point == point) ++next_s;
    while (next_e < ends_.size() && ends_[next_e].point == point) ++next_e;
    if (!pass(std::span(starts_).subspan(s, next_s - s), next_e - e, point)) return false;
    s = next_s;
    e = next_e;
  }
  return front_.empty();
}

bool RimSweep::sort_starting(std::span<const Event> starting) {
  starting_.clear();
  for (const Event& event : starting) starting_.push_back(event.edge);
  bool parallel = false;
  std::sort(starting_.begin(), starting_.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (a == b) return false;
    const Sign s = turn(edges_[a], edges_[b].right);
    if (s == Sign::zero) parallel = true;
    return s == Sign::positive;
  });
  return !parallel;
}

// Edges that are in this order stay so until one of them ends, or end together.
bool RimSweep::stay_apart(const Edge& below, const Edge& above) const {
  if (below.right == above.right) return true;
  const Sign s = before(below.right, above.right);
  if (s == Sign::zero) return false;
  return s == Sign::positive ? turn(above, below.right) == Sign::negative
                             : turn(below, above.right) == Sign::positive;
}

bool RimSweep::pass(std::span<const Event> starting, std::size_t ending, PointId point) {
  const auto lowest = std::partition_point(front_.begin(), front_.end(), [&](std::uint32_t e) {
    return edges_[e].right != point && turn(edges_[e], point) == Sign::positive;
  });
  auto at = lowest;
  for (std::size_t i = 0; i < ending; ++i, ++at)
    if (at == front_.end() || edges_[*at].right != point) return false;
  // Nothing else may go through the point.
  if (at != front_.end() &&
      (edges_[*at].right == point || turn(edges_[*at], point) != Sign::negative))
    return false;
  if (!sort_starting(starting)) return false;
  const auto first = lowest - front_.begin();
  const auto gap = front_.erase(lowest, at);
  front_.insert(gap, starting_.begin(), starting_.end());
  const auto last = first + static_cast<std::ptrdiff_t>(starting_.size());
  for (auto i = first; i <= last; ++i) {
    const bool has_below = i > 0, has_above = i < static_cast<std::ptrdiff_t>(front_.size());
    const Edge* below = has_below ? &edges_[front_[static_cast<std::size_t>(i - 1)]] : nullptr;
    const Edge* above = has_above ? &edges_[front_[static_cast<std::size_t>(i)]] : nullptr;
    // From below, the piece begins and ends in turn.
    if ((below && below->opens) == (!above || above->opens)) return false;
    if (below && above && !stay_apart(*below, *above)) return false;
  }
  return true;
}

}  // namespace sectile
