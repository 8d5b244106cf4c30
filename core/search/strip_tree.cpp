#include "search/strip_tree.h"

#include <cmath>

#include "numbers/rounding.h"

namespace sectile {
namespace {

// For a product x·i + y·j with coordinates up to `reach`: two products, a sum, and two coordinates
// that are rounded, each half an ulp of a term; twice that, and what underflow takes. What is not
// finite is never apart.
double error_of(double x, double y, double reach) {
  return 8 * rounding::unit * (std::abs(x) + std::abs(y)) * reach + 0x1p-1000 * (1 + reach);
}

// Of a division of something that has such an error.
double error_of_quotient(double q, double error, double divisor) {
  return 4 * rounding::unit * std::abs(q) + 2 * error / std::abs(divisor) + 0x1p-1000;
}

// So often must regions cover the whole to count as lying around each other.
constexpr double many_times = 4;

}  // namespace

StripTree::Target::Target(std::span<const Vec3> polygon) : slab(polygon) {
  Bounds bounds;
  for (const Vec3& p : polygon) bounds.add(p);
  box = bounds.box();
  if (polygon.size() > corners.size()) return;
  corner_count = static_cast<std::uint32_t>(polygon.size());
  std::copy(polygon.begin(), polygon.end(), corners.begin());
}

StripTree::StripTree(std::span<const Edge> edges, int axis)
    : i_((axis + 1) % 3), j_((axis + 2) % 3) {
  build_boxes(edges);
  double sum = 0;
  for (const Box& b : edge_boxes_) sum += area(b);
  if (sum > many_times * area(boxes_.back().front())) build_strips(edges);
}

void StripTree::build_boxes(std::span<const Edge> edges) {
  const std::size_t count = edges.size();
  edge_boxes_.reserve(count);
  for (const Edge& e : edges) edge_boxes_.push_back(box_around(e.from, e.to));
  boxes_.emplace_back((count + leaf_size - 1) / leaf_size);
  for (std::size_t e = 0; e < count; ++e) boxes_[0][e / leaf_size].add(edge_boxes_[e]);
  while (boxes_.back().size() > 1) {
    const std::vector<Box>& below = boxes_.back();
    std::vector<Box> level((below.size() + 1) / 2);
    for (std::size_t i = 0; i < below.size(); ++i) level[i / 2].add(below[i]);
    boxes_.push_back(std::move(level));
  }
}

double StripTree::area(const Box& box) const {
  return (double(box.high[i_]) - double(box.low[i_])) *
         (double(box.high[j_]) - double(box.low[j_]));
}

// Of what of the strip is around the box, about.
double StripTree::area(const Box& box, const Strip& strip) const {
  const double along = std::abs(strip.y) * (double(box.high[i_]) - double(box.low[i_])) +
                       std::abs(strip.x) * (double(box.high[j_]) - double(box.low[j_]));
  return (strip.high - strip.low) * along / (strip.x * strip.x + strip.y * strip.y);
}

bool StripTree::is_crowded() const {
  if (boxes_.size() == 1) return false;
  double sum = 0;
  for (std::size_t i = 0; i < boxes_[0].size(); ++i) {
    const Box& box = boxes_[0][i];
    sum += strips_.empty() ? area(box) : std::min(area(box), area(box, strips_[0][i]));
  }
  return sum > many_times * area(boxes_.back().front());
}

void StripTree::build_strips(std::span<const Edge> edges) {
  edge_strips_.reserve(edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e)
    edge_strips_.push_back(strip_around(edges.subspan(e, 1)));
  for (std::uint32_t level = 0; level < boxes_.size(); ++level) {
    strips_.emplace_back();
    for (std::uint32_t index = 0; index < boxes_[level].size(); ++index) {
      const Node n{level, index};
      strips_.back().push_back(strip_around(edges.subspan(begin(n), end(n) - begin(n))));
    }
  }
}

// Along the longest one.
StripTree::Strip StripTree::strip_around(std::span<const Edge> edges) const {
  Strip strip{0, 0, 0, 0};
  double longest = 0, reach = 0;
  for (const Edge& e : edges) {
    const double along_i = component(e.to, i_) - component(e.from, i_),
                 along_j = component(e.to, j_) - component(e.from, j_);
    const double length = std::abs(along_i) + std::abs(along_j);
    for (const Vec3& end : {e.from, e.to})
      reach = std::max({reach, std::abs(component(end, i_)), std::abs(component(end, j_))});
    if (!(length > longest)) continue;
    longest = length;
    strip.x = -along_j / length;
    strip.y = along_i / length;
  }
  const auto at = [&](const Vec3& p) {
    return strip.x * component(p, i_) + strip.y * component(p, j_);
  };
  strip.low = strip.high = at(edges.front().from);
  for (const Edge& e : edges)
    for (const Vec3& end : {e.from, e.to}) {
      strip.low = std::min(strip.low, at(end));
      strip.high = std::max(strip.high, at(end));
    }
  const double error = error_of(strip.x, strip.y, reach);
  strip.low -= error;
  strip.high += error;
  return strip;
}

bool StripTree::is_near(const Strip& strip, const Target& target) const {
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

StripTree::Side StripTree::side(const Box& box, const Strip* along, const Place& place) const {
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

StripTree::Stretch StripTree::on_ray(const Box& box, const Strip* along, const Place& place) const {
  Stretch stretch{box.low[i_], box.high[i_]};
  if (!along || along->x == 0) return stretch;
  // x·i is from low - y·j to high - y·j.
  const Strip& strip = *along;
  const double at_low = strip.y * place.low[1], at_high = strip.y * place.high[1];
  const double low = strip.low - std::max(at_low, at_high),
               high = strip.high - std::min(at_low, at_high);
  const double reach =
      std::max({std::abs(place.low[1]), std::abs(place.high[1]), std::abs(low), std::abs(high)});
  const double error = error_of(1, strip.y, reach);
  const auto [from, to] = std::minmax({low / strip.x, high / strip.x});
  // What is not a number tells nothing.
  stretch.from = std::max(stretch.from, from - error_of_quotient(from, error, strip.x));
  stretch.to = std::min(stretch.to, to + error_of_quotient(to, error, strip.x));
  return stretch;
}

void StripTree::FirstOnRay::add(std::uint32_t crossed, const Stretch& at) {
  if (at.to < to) {
    next_from = std::min(next_from, from);
    edge = crossed;
    from = at.from;
    to = at.to;
  } else {
    next_from = std::min(next_from, at.from);
  }
}

}  // namespace sectile
