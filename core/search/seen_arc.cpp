#include "search/seen_arc.h"

#include <algorithm>
#include <optional>
#include <utility>
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

struct Weights {
  double first, last, off;
};

// A direction as a sum of two others, and how far it is off that. If doubles do not tell what is
// between these, or it is not, it is one of them.
Weights weights(const Vec3& d, const Vec3& first, const Vec3& last) {
  const double cosine = dot(first, last), square = 1 - cosine * cosine;
  const double along = dot(d, first), across = dot(d, last);
  const double of_first = (along - cosine * across) / square,
               of_last = (across - cosine * along) / square;
  if (of_first >= 0 && of_last >= 0 && of_first + of_last < 2)
    return {of_first, of_last, root_of_square(d - (of_first * first + of_last * last))};
  const double from_first = root_of_square(d - first), from_last = root_of_square(d - last);
  return from_first < from_last ? Weights{1, 0, from_first} : Weights{0, 1, from_last};
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

bool SeenArc::is_thin() const {
  return *std::ranges::max_element(radius_) < coarsest;
}

// A direction of the face is a sum of those of the corners with weights of at least zero. Each of
// these is a sum of both ends, of which the one that it has more of gets what it is off, and of an
// error; as unit vectors, those that are off by less than the coarsest have weights of more than
// 15/16 together. The middle is the sum of the ends, made shorter.
SeenArc SeenArc::from_point(const Vec3& point, std::span<const Vec3> corners) {
  std::array<Vec3, 4> few;
  std::vector<Vec3> many(corners.size() > few.size() ? corners.size() : 0);
  const std::span<Vec3> directions =
      std::span(many.empty() ? few.data() : many.data(), corners.size());
  double error = roundings;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto to = direction(point, corners[i]);
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
  std::array<double, 2> radius{};  // of both ends
  for (const Vec3& d : directions) {
    if (&d == &first || &d == &last) continue;
    Weights of = weights(d, first, arc.way_[1]);
    if (arc.count_ == 3) {
      const Weights beyond = weights(d, last, arc.way_[1]);
      const bool is_beyond = beyond.off < of.off;
      if (is_beyond) of = beyond;
      of.last /= sum;  // the middle has as much of both
      of.first += of.last;
      if (is_beyond) std::swap(of.first, of.last);
    }
    if (!(of.off < coarsest)) return {};
    const bool more_of_last = of.last > of.first;
    radius[more_of_last] =
        std::max(radius[more_of_last], of.off / (more_of_last ? of.last : of.first));
  }
  for (double& r : radius) r = 1.125 * (r + error);
  const double of_middle = (radius[0] + radius[1]) / sum;
  arc.radius_ = {radius[0], arc.count_ == 3 ? of_middle : radius[1],
                 arc.count_ == 3 ? radius[1] : 0};
  return arc.is_thin() ? arc : SeenArc();
}

// A direction of the face is a sum of that of the edge, forward or backward, and of those of the
// other corners, with weights of at least zero. What is across the edge adds up; so it is off the
// half turn by what each corner is off, beside how far that is across, and by the error of the
// edge.
SeenArc SeenArc::from_edge(const Vec3& point, const Vec3& end, std::span<const Vec3> others) {
  const auto along = direction(point, end);
  if (!along || others.empty()) return {};
  const auto beside = [&](const Vec3& way) { return way - dot(way, along->way) * along->way; };
  std::vector<Direction> across;
  for (const Vec3& p : others) {
    const auto to = direction(point, p);
    if (!to) return {};
    across.push_back({beside(to->way), to->error + along->error + roundings});
  }
  const Vec3& farthest = std::ranges::max_element(across, {}, [](const Direction& d) {
                           return dot(d.way, d.way);
                         })->way;
  const double size = root_of_square(farthest);
  if (!(size > 0)) return {};
  const Vec3 middle = beside((1 / size) * farthest);
  SeenArc arc;
  arc.way_ = {along->way, (1 / root_of_square(middle)) * middle, -1 * along->way};
  arc.count_ = 3;
  double off = 0;
  for (const auto& [way, error] : across) {
    const double height = dot(way, arc.way_[1]);
    if (!(height > 2 * error)) return {};
    off = std::max(off, (root_of_square(way - height * arc.way_[1]) + error) / (height - error));
  }
  const double of_ends = along->error + roundings;
  arc.radius_ = {of_ends, 1.125 * (off + of_ends), of_ends};
  return arc.is_thin() ? arc : SeenArc();
}

}  // namespace sectile
