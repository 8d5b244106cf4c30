#include "search/oriented_box.h"

#include <utility>

#include "numbers/rounding.h"
#include "search/approximate.h"

namespace sectile {
namespace {

using namespace approximate;
using rounding::unit;

// For all errors of rounding in what is left of a point, and in what apart() computes with the box:
// less than 256 times half an ulp of the greatest coordinate each, as extents are at most four
// times that. Underflow takes less than the least slack. With numbers near the end of doubles
// nothing is certain.
double slack_for(double reach) {
  return reach < 0x1p500 ? 1024 * unit * reach + 0x1p-900 : std::numeric_limits<double>::infinity();
}

template <class Measure>
Vec3 farthest(std::span<const Vec3> points, const Measure& measure) {
  Vec3 best = points[0];
  double most = -1;
  for (const Vec3& p : points)
    if (const double m = measure(p); m > most) {
      most = m;
      best = p;
    }
  return best;
}

// Not zero; what is too small or large for doubles becomes something else, and the box loose.
Vec3 normalized(const Vec3& v, const Vec3& otherwise) {
  const double length = std::sqrt(dot(v, v));
  return length > 0x1p-500 && length < 0x1p500 ? (1 / length) * v : otherwise;
}

Vec3 across(const Vec3& v) {
  const Vec3 any = std::abs(v.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  return normalized(cross(v, any), {0, 0, 1});
}

void choose_axes(OrientedBox& box, std::span<const Vec3> points) {
  const Vec3 from =
      farthest(points, [&](const Vec3& p) { return dot(p - points[0], p - points[0]); });
  const Vec3 to = farthest(points, [&](const Vec3& p) { return dot(p - from, p - from); });
  const Vec3 along = normalized(to - from, {1, 0, 0});
  const Vec3 aside = farthest(points, [&](const Vec3& p) {
    const Vec3 off = cross(along, p - from);
    return dot(off, off);
  });
  // What rounding has made of a product of almost parallel vectors is at right angles to neither.
  const Vec3 off = cross(along, aside - from);
  const bool parallel = dot(off, off) < 0x1p-40 * dot(aside - from, aside - from);
  const Vec3 normal = parallel ? across(along) : normalized(off, across(along));
  box.axis[0] = along;
  box.axis[1] = normalized(cross(normal, along), across(along));
  box.axis[2] = normal;
}

}  // namespace

OrientedBox::OrientedBox(std::span<const Vec3> points) {
  choose_axes(*this, points);
  const Vec3 start = points[0];
  double low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
  for (const Vec3& p : points)
    for (int i = 0; i < 3; ++i) {
      const double at = dot(axis[i], p - start);
      low[i] = std::min(low[i], at);
      high[i] = std::max(high[i], at);
    }
  centre = start;
  for (int i = 0; i < 3; ++i) {
    centre = centre + (0.5 * (low[i] + high[i])) * axis[i];
    extent[i] = 0.5 * (high[i] - low[i]);
  }
  double left = 0, reach = max_norm(centre);
  for (const Vec3& p : points) {
    Vec3 rest = p - centre;
    for (int i = 0; i < 3; ++i)
      rest = rest - std::clamp(dot(axis[i], p - centre), -extent[i], extent[i]) * axis[i];
    left = std::max(left, max_norm(rest));
    reach = std::max(reach, max_norm(p));
  }
  slack = left + slack_for(reach);
}

OrientedBox::OrientedBox(const Box& box) {
  const Vec3 low{box.low[0], box.low[1], box.low[2]}, high{box.high[0], box.high[1], box.high[2]};
  centre = 0.5 * (low + high);
  const Vec3 half = 0.5 * (high - low);
  const double size[3] = {half.x, half.y, half.z};
  constexpr Vec3 unit_vector[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  int order[3] = {0, 1, 2};
  std::sort(order, order + 3, [&](int i, int j) { return size[i] > size[j]; });
  for (int i = 0; i < 3; ++i) {
    axis[i] = unit_vector[order[i]];
    extent[i] = size[order[i]];
  }
  slack = slack_for(max_norm(centre) + max_norm(half));
}

namespace {

struct PairOfBoxes {
  const OrientedBox &a, &b;
  Vec3 between;

  static double radius(const OrientedBox& box, const Vec3& direction, double size) {
    return box.slack * size + box.extent[0] * std::abs(dot(box.axis[0], direction)) +
           box.extent[1] * std::abs(dot(box.axis[1], direction)) +
           box.extent[2] * std::abs(dot(box.axis[2], direction));
  }
  // The direction is about a unit vector, or the product of two.
  bool separated_along(const Vec3& direction) const {
    const double size = sum_norm(direction);
    // Of parallel axes, nothing but rounding is left.
    return size > 0x1p-30 && std::abs(dot(between, direction)) >
                                 radius(a, direction, size) + radius(b, direction, size);
  }
};

}  // namespace

bool apart(const OrientedBox& a, const OrientedBox& b) {
  const PairOfBoxes pair{a, b, b.centre - a.centre};
  for (const int i : {2, 1, 0})
    if (pair.separated_along(a.axis[i]) || pair.separated_along(b.axis[i])) return true;
  for (const Vec3& u : a.axis)
    for (const Vec3& v : b.axis)
      if (pair.separated_along(cross(u, v))) return true;
  return false;
}

}  // namespace sectile
