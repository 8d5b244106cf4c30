#include "search/seen_arc.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "numbers/rounding.h"
#include "search/approximate.h"

namespace sectile {

using namespace approximate;

namespace {

using rounding::unit;

// Of a unit vector, and of what is computed with it.
constexpr double roundings = 32 * unit;
// With a greater error, arcs tell nothing.
constexpr double coarsest = 0x1p-4;
// The square of a length within these bounds is a normal double.
constexpr double least_length = 0x1p-500, greatest_length = 0x1p500;

// Without regard to overflow.
double root_of_square(const Vec3& v) {
  return std::sqrt(dot(v, v));
}

// Two rounded positions and their difference are off by 4 u (|p| + |q|), together.
double error_of_difference(const Vec3& p, const Vec3& q) {
  return 4 * unit * (max_norm(p) + max_norm(q));
}

struct Direction {
  Vec3 way;
  double error;
};

std::optional<Direction> direction(const Vec3& from, const Vec3& to) {
  const Vec3 way = to - from;
  const double size = root_of_square(way);
  if (!(size > least_length && size < greatest_length)) return {};
  return Direction{(1 / size) * way, 2 * error_of_difference(from, to) / size + roundings};
}

const Vec3& farthest_from(const Vec3& from, std::span<const Vec3> directions) {
  return *std::ranges::min_element(directions, {}, [&](const Vec3& d) { return dot(from, d); });
}

// How far a direction is from what lies between two others, or less.
double distance_from_sector(const Vec3& d, const Vec3& first, const Vec3& last) {
  const double cosine = dot(first, last);
  const Vec3 across = last - cosine * first;
  const double sine = root_of_square(across);
  if (sine > 0) {
    const double along = dot(d, first), beside = dot(d, across) / sine;
    if (beside >= 0 && along * sine >= beside * cosine)
      return root_of_square(d - (along * first + (beside / sine) * across));
  }
  return std::min(root_of_square(d - first), root_of_square(d - last));
}

}  // namespace

SeenArc SeenArc::between(const Vec3& first, const Vec3& last) {
  SeenArc arc;
  if (dot(first, last) >= 0) {
    arc.way_ = {first, last};
    arc.count_ = 2;
  } else {
    const Vec3 sum = first + last;
    arc.way_ = {first, (1 / root_of_square(sum)) * sum, last};
    arc.count_ = 3;
  }
  return arc;
}

double SeenArc::distance(const Vec3& direction) const {
  double least = distance_from_sector(direction, way_[0], way_[1]);
  if (count_ == 3) least = std::min(least, distance_from_sector(direction, way_[1], way_[2]));
  return least;
}

// A direction of the face is a sum of those of the corners with weights of at least zero, each of
// which is off by e at most. With s for the length of the sum of both ends, such a sum with weights
// that add up to one is longer than (1 - e) s / 2, so that it is off by 2 e / s (1 - e) beside its
// length; that is less than 1/4, with unit vectors less than 1.02 times as much.
SeenArc SeenArc::from_corner(const Vec3& corner, std::span<const Vec3> others) {
  std::array<Vec3, 4> few;
  std::vector<Vec3> many(others.size() > few.size() ? others.size() : 0);
  const std::span<Vec3> directions =
      std::span(many.empty() ? few.data() : many.data(), others.size());
  double error = roundings;
  for (std::size_t i = 0; i < others.size(); ++i) {
    const auto to = direction(corner, others[i]);
    if (!to) return {};
    directions[i] = to->way;
    error = std::max(error, to->error);
  }
  if (directions.empty()) return {};
  const Vec3 &first = farthest_from(directions[0], directions),
             &last = farthest_from(first, directions);
  const double sum = root_of_square(first + last);
  if (!(coarsest * sum > error)) return {};
  SeenArc arc = between(first, last);
  double off = 0;
  for (const Vec3& d : directions)
    if (&d != &first && &d != &last) off = std::max(off, arc.distance(d));
  arc.error_ = 2.5 * (off + error) / sum;
  return arc.error_ < coarsest ? arc : SeenArc();
}

}  // namespace sectile
