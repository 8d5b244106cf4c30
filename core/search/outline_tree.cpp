#include "search/outline_tree.h"

#include <cmath>
#include <numeric>

#include "numbers/rounding.h"
#include "numbers/threshold.h"
#include "search/curve_order.h"

namespace sectile {
namespace {

// For a product x·i + y·j with coordinates up to `reach`: two products, a sum, and two coordinates
// that are rounded, each half an ulp of a term; twice that, and what underflow takes. What is not
// finite is never apart.
double error_of(double x, double y, double reach) {
  return 8 * rounding::unit * (std::abs(x) + std::abs(y)) * reach + 0x1p-1000 * (1 + reach);
}

}  // namespace

OutlineTree::Target::Target(std::span<const Vec3> polygon) : slab(polygon) {
  Bounds bounds;
  for (const Vec3& p : polygon) bounds.add(p);
  box = bounds.box();
  if (polygon.size() > corners.size()) return;
  corner_count = static_cast<std::uint32_t>(polygon.size());
  std::copy(polygon.begin(), polygon.end(), corners.begin());
}

OutlineTree::OutlineTree(std::span<const Vec3> corners, std::span<const std::uint32_t> loop_ends,
                         int axis)
    : i_((axis + 1) % 3), j_((axis + 2) % 3), as_target_(corners) {
  sort_loops(corners, loop_ends);
  build_boxes(corners);
  if (is_slanted()) build_strips(corners);
}

// Loops that follow each other are near each other.
void OutlineTree::sort_loops(std::span<const Vec3> corners,
                             std::span<const std::uint32_t> loop_ends) {
  order_.reserve(corners.size());
  loop_begin_.reserve(corners.size());
  const auto add = [&](std::size_t loop) {
    const auto begin = static_cast<std::uint32_t>(order_.size());
    for (std::uint32_t c = loop > 0 ? loop_ends[loop - 1] : 0; c < loop_ends[loop]; ++c) {
      order_.push_back(c);
      loop_begin_.push_back(begin);
    }
  };
  constexpr std::size_t few_loops = threshold(4, 1);
  if (loop_ends.size() <= few_loops) {
    for (std::size_t loop = 0; loop < loop_ends.size(); ++loop) add(loop);
    return;
  }
  const auto first_corner = [&](std::size_t loop) {
    return corners[loop > 0 ? loop_ends[loop - 1] : 0];
  };
  for (const std::uint64_t key : keys_along_curve(loop_ends.size(), as_target_.box, first_corner))
    add(static_cast<std::uint32_t>(key));
}

void OutlineTree::build_boxes(std::span<const Vec3> corners) {
  const auto count = static_cast<std::uint32_t>(order_.size());
  edge_boxes_.reserve(count);
  for (std::uint32_t e = 0; e < count; ++e)
    edge_boxes_.push_back(box_around(corners[order_[e]], corners[order_[next(e)]]));
  boxes_.emplace_back((count + leaf_size - 1) / leaf_size);
  for (std::uint32_t e = 0; e < count; ++e) boxes_[0][e / leaf_size].add(edge_boxes_[e]);
  while (boxes_.back().size() > 1) {
    const std::vector<Box>& below = boxes_.back();
    std::vector<Box> level((below.size() + 1) / 2);
    for (std::size_t i = 0; i < below.size(); ++i) level[i / 2].add(below[i]);
    boxes_.push_back(std::move(level));
  }
}

// Do the boxes of edges cover each other many times over?
bool OutlineTree::is_slanted() const {
  constexpr double many_times = 4;
  const auto area = [&](const Box& b) {
    return (double(b.high[i_]) - double(b.low[i_])) * (double(b.high[j_]) - double(b.low[j_]));
  };
  double sum = 0;
  for (const Box& b : edge_boxes_) sum += area(b);
  return sum > many_times * area(boxes_.back().front());
}

// Where the edge ends, in the order of the tree.
std::uint32_t OutlineTree::next(std::uint32_t e) const {
  const bool closes = e + 1 == order_.size() || loop_begin_[e + 1] != loop_begin_[e];
  return closes ? loop_begin_[e] : e + 1;
}

void OutlineTree::build_strips(std::span<const Vec3> corners) {
  edge_strips_.reserve(order_.size());
  for (std::uint32_t e = 0; e < order_.size(); ++e)
    edge_strips_.push_back(strip_around(corners, e, e + 1));
  for (std::uint32_t level = 0; level < boxes_.size(); ++level) {
    strips_.emplace_back();
    for (std::uint32_t index = 0; index < boxes_[level].size(); ++index)
      strips_.back().push_back(strip_around(corners, begin({level, index}), end({level, index})));
  }
}

// Along the longest one of some edges.
OutlineTree::Strip OutlineTree::strip_around(std::span<const Vec3> corners, std::uint32_t from,
                                             std::uint32_t to) const {
  const auto at_i = [&](std::uint32_t e) { return component(corners[order_[e]], i_); };
  const auto at_j = [&](std::uint32_t e) { return component(corners[order_[e]], j_); };
  Strip strip{0, 0, 0, 0};
  double longest = 0, reach = 0;
  for (std::uint32_t e = from; e < to; ++e) {
    const std::uint32_t f = next(e);
    const double along_i = at_i(f) - at_i(e), along_j = at_j(f) - at_j(e);
    const double length = std::abs(along_i) + std::abs(along_j);
    for (const std::uint32_t end : {e, f})
      reach = std::max({reach, std::abs(at_i(end)), std::abs(at_j(end))});
    if (!(length > longest)) continue;
    longest = length;
    strip.x = -along_j / length;
    strip.y = along_i / length;
  }
  const auto at = [&](std::uint32_t e) { return strip.x * at_i(e) + strip.y * at_j(e); };
  strip.low = strip.high = at(from);
  for (std::uint32_t e = from; e < to; ++e)
    for (const std::uint32_t end : {e, next(e)}) {
      strip.low = std::min(strip.low, at(end));
      strip.high = std::max(strip.high, at(end));
    }
  const double error = error_of(strip.x, strip.y, reach);
  strip.low -= error;
  strip.high += error;
  return strip;
}

bool OutlineTree::is_near(const Strip& strip, const Target& target) const {
  if (target.corner_count == 0) return true;
  double low = std::numeric_limits<double>::infinity(), high = -low, reach = 0;
  for (std::uint32_t c = 0; c < target.corner_count; ++c) {
    const double i = component(target.corners[c], i_), j = component(target.corners[c], j_);
    const double at = strip.x * i + strip.y * j;
    low = std::min(low, at);
    high = std::max(high, at);
    reach = std::max({reach, std::abs(i), std::abs(j)});
  }
  const double error = error_of(strip.x, strip.y, reach);
  return !(high + error < strip.low || low - error > strip.high);
}

OutlineTree::Side OutlineTree::side(const Box& box, const Strip* along, const Place& place) const {
  if (place.low[1] > box.high[j_] || place.high[1] < box.low[j_] || place.low[0] > box.high[i_])
    return Side::aside;
  if (place.high[0] < box.low[i_]) return Side::ahead;
  if (!along) return Side::around;
  const Strip& strip = *along;
  const int i = strip.x < 0 ? 1 : 0, j = strip.y < 0 ? 1 : 0;  // where the low ends count as low
  const double* const end[2] = {place.low, place.high};
  const double low = strip.x * end[i][0] + strip.y * end[j][1],
               high = strip.x * end[1 - i][0] + strip.y * end[1 - j][1];
  double reach = 0;
  for (const double* ends : end) reach = std::max({reach, std::abs(ends[0]), std::abs(ends[1])});
  const double error = error_of(strip.x, strip.y, reach);
  if (low - error > strip.high) return strip.x < 0 ? Side::ahead : Side::aside;
  if (high + error < strip.low) return strip.x > 0 ? Side::ahead : Side::aside;
  return Side::around;
}

}  // namespace sectile
