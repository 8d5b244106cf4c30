#include "boolean/joining/next_loops.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "geometry/axes.h"
#include "search/bucket_sort.h"

namespace sectile {
namespace {

// Places of corners, numbered by their height (j), and from left to right (i) on one level.
class SortedPlaces {
 public:
  SortedPlaces(const Kernel& kernel, int axis, std::span<const PointId> corners)
      : kernel_(kernel), i_(next_axis(axis)), j_(next_next_axis(axis)) {
    std::vector<std::uint32_t> order(corners.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t c, std::uint32_t d) {
      const Sign up = along(corners[c], corners[d], j_);
      return (up == Sign::zero ? along(corners[c], corners[d], i_) : up) == Sign::positive;
    });
    of_corner_.resize(corners.size());
    for (const std::uint32_t c : order) {
      add(corners[c]);
      of_corner_[c] = count() - 1;
    }
  }

  std::uint32_t count() const { return static_cast<std::uint32_t>(point_.size()); }
  std::uint32_t of_corner(std::uint32_t corner) const { return of_corner_[corner]; }
  PointId point(std::uint32_t place) const { return point_[place]; }
  std::uint32_t level(std::uint32_t place) const { return level_[place]; }
  /// Does a place lie farther to the right than another one?
  bool is_right_of(std::uint32_t place, std::uint32_t other) const {
    return along(point_[other], point_[place], i_) == Sign::positive;
  }

 private:
  // Rounding to nearest is monotonic.
  Sign along(PointId p, PointId q, int axis) const {
    const double from = component(kernel_.geometry().position(p), axis),
                 to = component(kernel_.geometry().position(q), axis);
    if (from != to) return from < to ? Sign::positive : Sign::negative;
    return p == q ? Sign::zero : kernel_.compare(p, q, axis);
  }

  void add(PointId p) {
    const bool first = point_.empty();
    const bool higher = first || along(point_.back(), p, j_) != Sign::zero;
    if (!higher && along(point_.back(), p, i_) == Sign::zero) return;
    level_.push_back(first ? 0 : level_.back() + (higher ? 1 : 0));
    point_.push_back(p);
  }

  const Kernel& kernel_;
  int i_, j_;
  std::vector<std::uint32_t> of_corner_;
  std::vector<PointId> point_;        // per place
  std::vector<std::uint32_t> level_;  // per place
};

// A line goes up over the loops and knows which edges it crosses, from left to right. A ray starts
// right of the corner of a hole that is farthest to the right, a hair above the line: the first
// edge that it meets bounds the same region.
class LoopSweep {
 public:
  LoopSweep(const Kernel& kernel, PlaneId plane, std::span<const PointId> corners,
            std::span<const std::uint32_t> loop_ends, std::uint32_t holes)
      : kernel_(kernel),
        axis_(kernel.main_axis(plane)),
        upwards_has_left_(kernel.normal(plane, axis_) == Sign::positive),
        places_(kernel, axis_, corners),
        crossed_(InOrder{this}),
        next_(holes, NextLoops::none) {
    for (std::uint32_t l = 0; l < loop_ends.size(); ++l)
      add_loop(l, l == 0 ? 0 : loop_ends[l - 1], loop_ends[l]);
  }

  std::vector<std::uint32_t> run() {
    const auto place_of = [](const auto& x) { return x.place; };
    const auto no_matter = [](const auto& x, const auto& y) { return x.number < y.number; };
    first_end_ = bucket_sort(ends_, places_.count(), place_of, no_matter);
    first_ray_ = bucket_sort(rays_, places_.count(), place_of, no_matter);
    at_.resize(edges_.size());
    for (std::uint32_t from = 0, to; from < places_.count(); from = to) {
      for (to = from; to < places_.count() && places_.level(to) == places_.level(from);) ++to;
      cross_level(from, to);
    }
    return std::move(next_);
  }

 private:
  struct Edge {
    std::uint32_t low, high;  // places; of a level edge, the left one first
    std::uint32_t loop;
    bool has_left;  // does it bound what is left of it, rather than what is right of it?
  };
  struct End {
    std::uint32_t place, number;  // of the edge
  };
  struct Ray {
    std::uint32_t place, number;   // of the hole
    std::uint32_t before, behind;  // the corners beside that one
  };
  // Edges that one line crosses, and places on it: what the place is right of, or on, is before it.
  struct InOrder {
    using is_transparent = void;
    const LoopSweep* sweep;
    bool operator()(std::uint32_t e, std::uint32_t f) const { return sweep->is_before(e, f); }
    bool operator()(std::uint32_t e, const Ray& ray) const {
      return sweep->turn(e, ray.place) != Sign::positive;
    }
  };
  using Crossed = std::set<std::uint32_t, InOrder>;

  void add_loop(std::uint32_t loop, std::uint32_t from, std::uint32_t to) {
    if (from == to) return;
    std::uint32_t farthest = from;
    for (std::uint32_t c = from; c < to; ++c) {
      add_edge(loop, places_.of_corner(c), places_.of_corner(c + 1 < to ? c + 1 : from));
      if (places_.is_right_of(places_.of_corner(c), places_.of_corner(farthest))) farthest = c;
    }
    if (loop < next_.size())
      rays_.push_back({places_.of_corner(farthest), loop,
                       places_.of_corner(farthest > from ? farthest - 1 : to - 1),
                       places_.of_corner(farthest + 1 < to ? farthest + 1 : from)});
  }

  void add_edge(std::uint32_t loop, std::uint32_t from, std::uint32_t to) {
    const auto number = static_cast<std::uint32_t>(edges_.size());
    edges_.push_back(
        {std::min(from, to), std::max(from, to), loop, (from < to) == upwards_has_left_});
    ends_.push_back({from, number});
    ends_.push_back({to, number});
  }

  bool is_level(const Edge& e) const { return places_.level(e.low) == places_.level(e.high); }

  template <class Visit>
  void for_each_end(std::uint32_t place, const Visit& visit) const {
    for (std::uint32_t k = first_end_[place]; k < first_end_[place + 1]; ++k)
      visit(ends_[k].number);
  }

  // Edges end where they reach the line, and begin a hair above it.
  void cross_level(std::uint32_t from, std::uint32_t to) {
    for (std::uint32_t p = from; p < to; ++p)
      for_each_end(p, [&](std::uint32_t e) {
        if (edges_[e].high == p && !is_level(edges_[e])) crossed_.erase(at_[e]);
      });
    for (std::uint32_t p = from; p < to; ++p)
      for_each_end(p, [&](std::uint32_t e) {
        if (edges_[e].low == p && !is_level(edges_[e])) at_[e] = crossed_.insert(e).first;
      });
    std::uint32_t level_until = from;  // where the level edges end that have begun so far
    for (std::uint32_t p = from; p < to; ++p) {
      if (level_until <= p)
        for (std::uint32_t k = first_ray_[p]; k < first_ray_[p + 1]; ++k) cast(rays_[k]);
      for_each_end(p, [&](std::uint32_t e) {
        if (is_level(edges_[e])) level_until = std::max(level_until, edges_[e].high);
      });
    }
  }

  void cast(const Ray& ray) {
    if (!is_alone(ray)) return;
    const auto first = crossed_.lower_bound(ray);
    for (auto at = first; at != crossed_.begin();) {
      const Edge& e = edges_[*--at];
      if (e.low == ray.place) continue;  // few of them, as they are the hole's own
      if (turn(*at, ray.place) == Sign::zero) return;
      break;
    }
    if (first != crossed_.end() && edges_[*first].has_left) next_[ray.number] = edges_[*first].loop;
  }

  // Do no edges begin or end at the corner but its own, and those that go back along them?
  bool is_alone(const Ray& ray) const {
    constexpr std::uint32_t few = 8;
    if (first_end_[ray.place + 1] - first_end_[ray.place] > few) return false;
    bool alone = true;
    for_each_end(ray.place, [&](std::uint32_t e) {
      const std::uint32_t far = edges_[e].low == ray.place ? edges_[e].high : edges_[e].low;
      alone = alone && (far == ray.before || far == ray.behind);
    });
    return alone;
  }

  // Positive: the place is left of the edge.
  Sign turn(std::uint32_t e, std::uint32_t place) const {
    const Edge& edge = edges_[e];
    if (place == edge.low || place == edge.high) return Sign::zero;
    return kernel_.turn(places_.point(edge.low), places_.point(edge.high), places_.point(place),
                        axis_);
  }

  // As they do not cross, ends tell. Of those in one place, that one is before the other which
  // bounds what is left of both.
  bool is_before(std::uint32_t e, std::uint32_t f) const {
    const Edge &x = edges_[e], &y = edges_[f];
    Sign left = places_.level(y.low) < places_.level(x.low) ? turn(f, x.low) : -turn(e, y.low);
    if (left == Sign::zero)
      left = places_.level(x.high) < places_.level(y.high) ? turn(f, x.high) : -turn(e, y.high);
    if (left != Sign::zero) return left == Sign::positive;
    if (x.has_left != y.has_left) return x.has_left;
    return e < f;
  }

  const Kernel& kernel_;
  int axis_;
  bool upwards_has_left_;
  SortedPlaces places_;
  std::vector<Edge> edges_;
  std::vector<End> ends_;  // place by place
  std::vector<Ray> rays_;  // place by place
  std::vector<std::uint32_t> first_end_, first_ray_;
  Crossed crossed_;
  std::vector<Crossed::iterator> at_;  // per edge
  std::vector<std::uint32_t> next_;
};

}  // namespace

NextLoops::NextLoops(const Kernel& kernel, PlaneId plane, std::span<const PointId> corners,
                     std::span<const std::uint32_t> loop_ends, std::uint32_t holes)
    : next_(LoopSweep(kernel, plane, corners, loop_ends, holes).run()) {}

}  // namespace sectile
