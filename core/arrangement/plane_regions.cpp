#include "arrangement/plane_regions.h"

#include <algorithm>
#include <numeric>

#include "boolean/direction.h"
#include "geometry/face_predicates.h"
#include "geometry/sweep_line.h"

namespace sectile::arrangement {
namespace {

// Half-edge 2e runs along edge e from its low to its high end, 2e + 1 back.
class RegionFinder {
 public:
  RegionFinder(const PlanePieces& pieces, const Kernel& kernel)
      : pieces_(pieces), edges_(pieces.edges()), kernel_(kernel), plane_(pieces.plane()) {}

  Regions run() {
    number_vertices();
    sort_around_vertices();
    trace_loops();
    find_components();
    assign_regions();
    find_covers();
    return collect_regions();
  }

 private:
  std::uint32_t half_edges() const { return static_cast<std::uint32_t>(2 * edges_.size()); }
  std::uint32_t from(std::uint32_t h) const { return end_[h]; }
  std::uint32_t to(std::uint32_t h) const { return end_[h ^ 1u]; }
  std::span<const std::uint32_t> leaving(std::uint32_t v) const {
    const std::uint32_t begin = v > 0 ? leaving_end_[v - 1] : 0;
    return std::span(leaving_).subspan(begin, leaving_end_[v] - begin);
  }
  std::uint32_t vertex_count() const { return static_cast<std::uint32_t>(points_.size()); }

  void number_vertices() {
    for (const PlaneEdge& e : edges_) points_.insert(points_.end(), {e.low, e.high});
    std::sort(points_.begin(), points_.end());
    points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
    const auto number = [&](PointId p) {
      return static_cast<std::uint32_t>(std::lower_bound(points_.begin(), points_.end(), p) -
                                        points_.begin());
    };
    for (const PlaneEdge& e : edges_) {
      end_.push_back(number(e.low));
      end_.push_back(number(e.high));
    }
  }

  void sort_around_vertices() {
    leaving_end_.assign(vertex_count(), 0);
    for (const std::uint32_t v : end_) ++leaving_end_[v];
    std::partial_sum(leaving_end_.begin(), leaving_end_.end(), leaving_end_.begin());
    leaving_.resize(half_edges());
    std::vector<std::uint32_t> at(leaving_end_);
    for (std::uint32_t h = half_edges(); h-- > 0;) leaving_[--at[from(h)]] = h;
    place_.resize(half_edges());
    std::vector<std::pair<Direction, std::uint32_t>> around;
    for (std::uint32_t v = 0; v < vertex_count(); ++v) {
      const std::uint32_t begin = v > 0 ? leaving_end_[v - 1] : 0, end = leaving_end_[v];
      if (end - begin > 2) {
        around.clear();
        for (std::uint32_t i = begin; i < end; ++i)
          around.push_back({direction(leaving_[i]), leaving_[i]});
        const Direction start = around[0].first;
        std::sort(around.begin() + 1, around.end(), [&](const auto& a, const auto& b) {
          return before_counter_clockwise(kernel_, plane_, start, a.first, b.first);
        });
        for (std::uint32_t i = begin; i < end; ++i) leaving_[i] = around[i - begin].second;
      }
      for (std::uint32_t i = begin; i < end; ++i) place_[leaving_[i]] = i;
    }
  }
  Direction direction(std::uint32_t h) const {
    return direction_between(kernel_, plane_, edges_[h / 2].across, points_[from(h)],
                             points_[to(h)]);
  }

  // With the region on its left, what follows a half-edge leaves its end just clockwise of it.
  std::uint32_t next(std::uint32_t h) const {
    const std::uint32_t back = h ^ 1u, v = from(back);
    const std::uint32_t begin = v > 0 ? leaving_end_[v - 1] : 0;
    return leaving_[place_[back] > begin ? place_[back] - 1 : leaving_end_[v] - 1];
  }

  void trace_loops() {
    loop_of_.assign(half_edges(), none);
    for (std::uint32_t h = 0; h < half_edges(); ++h) {
      if (loop_of_[h] != none) continue;
      const auto loop = static_cast<std::uint32_t>(loop_first_.size());
      loop_first_.push_back(h);
      for (std::uint32_t g = h; loop_of_[g] == none; g = next(g)) loop_of_[g] = loop;
    }
  }

  FacePredicates predicates() const {
    const int axis = kernel_.main_axis(plane_);
    return {kernel_, axis, kernel_.normal(plane_, axis) == Sign::negative, points_};
  }

  // What hangs together, and its first vertex in the order of the sweep.
  void find_components() {
    component_.assign(vertex_count(), none);
    std::vector<std::uint32_t> front;
    const FacePredicates exact = predicates();
    for (std::uint32_t v = 0; v < vertex_count(); ++v) {
      if (component_[v] != none) continue;
      const auto number = static_cast<std::uint32_t>(leftmost_.size());
      leftmost_.push_back(v);
      component_[v] = number;
      front.push_back(v);
      while (!front.empty()) {
        const std::uint32_t at = front.back();
        front.pop_back();
        if (exact.compare(at, leftmost_[number]) == Sign::positive) leftmost_[number] = at;
        for (const std::uint32_t h : leaving(at))
          if (std::uint32_t& c = component_[to(h)]; c == none) {
            c = number;
            front.push_back(to(h));
          }
      }
    }
  }

  // The loop around a component lies to the left of the uppermost edge at its first vertex.
  std::uint32_t outer_loop(std::uint32_t component, const FacePredicates& exact) const {
    const std::uint32_t v = leftmost_[component];
    const auto edges = leaving(v);
    std::uint32_t top = edges[0];
    for (const std::uint32_t h : edges)
      if (exact.turn(v, to(top), to(h)) == Sign::positive) top = h;
    return loop_of_[top];
  }

  void assign_regions() {
    const FacePredicates exact = predicates();
    region_of_loop_.assign(loop_first_.size(), none);
    std::vector<std::uint32_t> outer(leftmost_.size());
    is_outer_.assign(loop_first_.size(), 0);
    for (std::uint32_t c = 0; c < outer.size(); ++c) {
      outer[c] = outer_loop(c, exact);
      is_outer_[outer[c]] = 1;
    }
    regions_ = 1;  // region 0 reaches to infinity
    for (std::uint32_t l = 0; l < region_of_loop_.size(); ++l)
      if (!is_outer_[l]) region_of_loop_[l] = regions_++;
    if (outer.size() == 1)
      region_of_loop_[outer[0]] = 0;
    else
      sweep(exact, outer);
  }

  // From left to right: the edge just below the first vertex of a component is that of the region
  // in which it lies.
  void sweep(const FacePredicates& exact, const std::vector<std::uint32_t>& outer) {
    std::vector<std::uint32_t> order(vertex_count()), rank(vertex_count());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return exact.compare(a, b) == Sign::positive;
    });
    for (std::uint32_t i = 0; i < order.size(); ++i) rank[order[i]] = i;
    SweepLine line(edges_.size());
    // Each edge by its half-edge to the right.
    std::vector<std::uint32_t> rightward(edges_.size());
    for (std::uint32_t e = 0; e < edges_.size(); ++e)
      rightward[e] = 2 * e + (rank[from(2 * e)] < rank[to(2 * e)] ? 0 : 1);
    std::vector<std::uint32_t> right;
    for (const std::uint32_t v : order) {
      right.clear();
      std::uint32_t lowest = SweepLine::none;
      for (const std::uint32_t h : leaving(v))
        (rank[to(h)] > rank[v] ? right.push_back(h) : void(lowest = h / 2));
      SweepLine::Gap gap;
      if (lowest == SweepLine::none) {
        gap = line.locate([&](std::uint32_t e) {
          return exact.turn(from(rightward[e]), to(rightward[e]), v) == Sign::positive;
        });
      } else {
        for (std::uint32_t e; (e = line.below(lowest)) != SweepLine::none && to(rightward[e]) == v;)
          lowest = e;
        gap.below = line.below(lowest);
        for (const std::uint32_t h : leaving(v))
          if (rank[to(h)] < rank[v]) line.remove(h / 2);
      }
      const std::uint32_t component = component_[v];
      if (leftmost_[component] == v)
        region_of_loop_[outer[component]] =
            gap.below == SweepLine::none ? 0 : region_of_loop_[loop_of_[rightward[gap.below]]];
      std::sort(right.begin(), right.end(), [&](std::uint32_t a, std::uint32_t b) {
        return a != b && exact.turn(v, to(a), to(b)) == Sign::positive;
      });
      for (const std::uint32_t h : right) {
        line.insert_above(gap.below, h / 2);
        gap.below = h / 2;
      }
    }
  }

  // Crossing the border of a face leads into it or out of it.
  void find_covers() {
    std::vector<std::uint32_t> end(regions_, 0), half_edge(half_edges());
    for (std::uint32_t h = 0; h < half_edges(); ++h) ++end[region(h)];
    std::partial_sum(end.begin(), end.end(), end.begin());
    std::vector<std::uint32_t> at(end);
    for (std::uint32_t h = half_edges(); h-- > 0;) half_edge[--at[region(h)]] = h;
    covers_.resize(regions_);
    std::vector<std::uint8_t> seen(regions_, 0);
    std::vector<std::uint32_t> front{0};
    seen[0] = 1;
    while (!front.empty()) {
      const std::uint32_t r = front.back();
      front.pop_back();
      for (std::uint32_t i = at[r]; i < end[r]; ++i) {
        const std::uint32_t h = half_edge[i], beyond = region(h ^ 1u);
        if (seen[beyond]) continue;
        seen[beyond] = 1;
        covers_[beyond] = covers_[r];
        for (const PlaneEdge::Border& b : pieces_.borders(edges_[h / 2]))
          toggle(covers_[beyond], b.face);
        front.push_back(beyond);
      }
    }
  }
  std::uint32_t region(std::uint32_t h) const { return region_of_loop_[loop_of_[h]]; }

  static void toggle(std::vector<std::uint32_t>& cover, std::uint32_t face) {
    const auto at = std::lower_bound(cover.begin(), cover.end(), face);
    if (at != cover.end() && *at == face)
      cover.erase(at);
    else
      cover.insert(at, face);
  }

  Regions collect_regions() const {
    // The loops of each region, its own first; those around components follow.
    std::vector<std::vector<std::uint32_t>> inner(regions_);
    std::vector<std::uint32_t> own(regions_, none);
    for (std::uint32_t l = 0; l < region_of_loop_.size(); ++l) {
      const std::uint32_t r = region_of_loop_[l];
      if (is_outer_[l])
        inner[r].push_back(l);
      else
        own[r] = l;
    }
    Regions result;
    for (std::uint32_t r = 1; r < regions_; ++r) {
      if (covers_[r].empty()) continue;
      add_loop(own[r], result);
      for (const std::uint32_t l : inner[r]) add_loop(l, result);
      result.region_end.push_back(static_cast<std::uint32_t>(result.loop_end.size()));
      result.cover.insert(result.cover.end(), covers_[r].begin(), covers_[r].end());
      result.cover_end.push_back(static_cast<std::uint32_t>(result.cover.size()));
    }
    return result;
  }
  void add_loop(std::uint32_t loop, Regions& result) const {
    const std::uint32_t first = loop_first_[loop];
    std::uint32_t h = first;
    do {
      result.corners.push_back(points_[from(h)]);
      result.across.push_back(edges_[h / 2].across);
      result.row.push_back(edges_[h / 2].row);
      h = next(h);
    } while (h != first);
    result.loop_end.push_back(static_cast<std::uint32_t>(result.corners.size()));
  }

  const PlanePieces& pieces_;
  const std::vector<PlaneEdge>& edges_;
  const Kernel& kernel_;
  PlaneId plane_;
  std::vector<PointId> points_;     // per vertex
  std::vector<std::uint32_t> end_;  // per half-edge: the vertex that it leaves
  std::vector<std::uint32_t> leaving_, leaving_end_, place_;  // counter-clockwise around vertices
  std::vector<std::uint32_t> loop_of_, loop_first_;
  std::vector<std::uint32_t> component_, leftmost_;
  std::vector<std::uint32_t> region_of_loop_;
  std::vector<std::uint8_t> is_outer_;  // per loop: around a component
  std::uint32_t regions_ = 0;
  std::vector<std::vector<std::uint32_t>> covers_;
};

}  // namespace

Regions find_regions(const PlanePieces& pieces, const Kernel& kernel) {
  return RegionFinder(pieces, kernel).run();
}

}  // namespace sectile::arrangement
