#include "search/edges_by_line.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/axes.h"
#include "numbers/rounding.h"
#include "numbers/threshold.h"
#include "search/approximate.h"
#include "search/box.h"

namespace sectile {
namespace {

using namespace approximate;

// An edge with a number that all edges on its line have, but for rounding, and few others.
struct Sorted {
  double at, error;
  std::uint32_t edge;
};

class LineFinder {
  // So many lines are told apart of which doubles know no difference.
  static constexpr std::size_t most_alike = threshold(8, 1);
  // Errors below this part of the whole tell lines apart.
  static constexpr double coarsest = 0x1p-20;

 public:
  LineFinder(const Kernel& kernel, std::span<const PointId> points,
             std::span<const PointPair> edges)
      : kernel_(kernel), points_(points), edges_(edges) {}

  std::vector<EdgesOfLine> run() {
    const std::vector<Sorted> sorted = sort_edges();
    double reach = -std::numeric_limits<double>::infinity();  // of those before, with their errors
    for (const Sorted& edge : sorted) {
      if (edge.at - edge.error > reach) first_near_ = lines_.size();
      reach = std::max(reach, edge.at + edge.error);
      add(edges_[edge.edge]);
    }
    for (EdgesOfLine& line : lines_) measure(line);
    return std::move(lines_);
  }

 private:
  const Vec3& at(std::uint32_t point) const { return kernel_.geometry().position(points_[point]); }

  std::vector<Sorted> sort_edges() const {
    Bounds bounds;
    for (const PointPair& e : edges_)
      for (const std::uint32_t p : {e.from, e.to}) bounds.add(at(p));
    const Vec3 size = bounds.high - bounds.low, centre = bounds.low + 0.5 * size;
    const double whole = max_norm(size),
                 largest = std::max(max_norm(bounds.low), max_norm(bounds.high));
    std::vector<Sorted> sorted;
    for (std::uint32_t i = 0; i < edges_.size(); ++i) {
      const Vec3 from = at(edges_[i].from) - centre, along = at(edges_[i].to) - at(edges_[i].from);
      const double length = std::sqrt(dot(along, along)),
                   error = 64 * rounding::unit * largest * (1 + whole / length);
      if (!(error < coarsest * whole)) continue;
      sorted.push_back({number_of(from, (1 / length) * along, whole), error, i});
    }
    std::ranges::sort(sorted, {}, [](const Sorted& e) { return std::pair(e.at, e.edge); });
    return sorted;
  }

  // Of the six coordinates of a line (its direction and its moment), put together so that lines of
  // a grid, or around an axis, have different ones.
  static double number_of(const Vec3& from, Vec3 direction, double whole) {
    constexpr Vec3 side{0.537, 0.619, 0.573}, of_direction{0.471, 0.329, 0.818},
        of_moment{0.713, 0.257, 0.652};
    if (dot(side, direction) < 0) direction = -1 * direction;
    return whole * dot(of_direction, direction) + dot(of_moment, cross(from, direction));
  }

  void add(const PointPair& edge) {
    for (std::size_t i = first_near_; i < lines_.size(); ++i) {
      const PointPair& first = lines_[i].edges.front();
      const auto is_on = [&](std::uint32_t p) {
        return p == first.from || p == first.to ||
               are_on_one_line(kernel_, points_[first.from], points_[first.to], points_[p]);
      };
      if (!is_on(edge.from) || !is_on(edge.to)) continue;
      lines_[i].edges.push_back(edge);
      return;
    }
    if (lines_.size() < first_near_ + most_alike) lines_.push_back({{edge}, edge});
  }

  void measure(EdgesOfLine& line) const {
    const auto [from, to] = line.edges.front();
    const int axis = longest_axis(at(to) - at(from));
    const auto on_axis = [&](std::uint32_t p) { return component(at(p), axis); };
    std::vector<std::uint32_t> low, high;
    for (const auto& [p, q] : line.edges) {
      const bool up = on_axis(p) <= on_axis(q);
      low.push_back(up ? p : q);
      high.push_back(up ? q : p);
    }
    std::ranges::sort(low, {}, on_axis);
    std::ranges::sort(high, {}, on_axis);
    line.extent = PointPair::between(low.front(), high.back());
    std::size_t ended = 0;
    for (std::size_t begun = 0; begun < low.size(); ++begun) {
      while (on_axis(high[ended]) <= on_axis(low[begun])) ++ended;
      line.beside += begun - ended;
    }
  }
  static int longest_axis(const Vec3& v) {
    int axis = 0;
    for (const int k : {1, 2})
      if (std::abs(component(v, k)) > std::abs(component(v, axis))) axis = k;
    return axis;
  }

  const Kernel& kernel_;
  std::span<const PointId> points_;
  std::span<const PointPair> edges_;
  std::vector<EdgesOfLine> lines_;
  std::size_t first_near_ = 0;  // of those with which the next edge may be on one line
};

}  // namespace

std::vector<EdgesOfLine> edges_by_line(const Kernel& kernel, std::span<const PointId> points,
                                       std::span<const PointPair> edges) {
  return LineFinder(kernel, points, edges).run();
}

std::vector<PointPair> crowded_lines(const Kernel& kernel, std::span<const PointId> points,
                                     std::span<const PointPair> edges, std::size_t others) {
  std::vector<PointPair> crowded;
  for (const EdgesOfLine& line : edges_by_line(kernel, points, edges))
    if (2 * line.beside >= others * line.edges.size()) crowded.push_back(line.extent);
  return crowded;
}

bool are_on_one_line(const Kernel& kernel, PointId p, PointId q, PointId r) {
  for (int axis = 0; axis < 3; ++axis)
    if (kernel.turn(p, q, r, axis) != Sign::zero) return false;
  return true;
}

bool is_within_edge(const Kernel& kernel, PointId p, PointId from, PointId to) {
  if (p == from || p == to || !are_on_one_line(kernel, from, to, p)) return false;
  for (int axis = 0; axis < 3; ++axis) {
    const Sign way = kernel.compare(from, to, axis);
    if (way != Sign::zero)
      return kernel.compare(from, p, axis) == way && kernel.compare(p, to, axis) == way;
  }
  return false;
}

}  // namespace sectile
