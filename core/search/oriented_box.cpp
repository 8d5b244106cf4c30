#include "search/oriented_box.h"

#include "numbers/rounding.h"
#include "numbers/threshold.h"
#include "search/approximate.h"

namespace sectile {
namespace {

using namespace approximate;
using rounding::unit;

// How far axes may be from unit vectors at right angles.
constexpr double most_skew = 16 * unit;

// For all errors of rounding in what is left of a point, and in what apart() computes with the box:
// that takes axes for exact ones, and extents are at most four times the greatest coordinate, so
// that it is off by less than 256 times the greatest skew, and by less than that times that
// coordinate. Underflow takes less than the least slack. With numbers near the end of doubles
// nothing is certain.
double slack_for(double reach) {
  return reach < 0x1p500 ? 256 * most_skew * reach + 0x1p-900
                         : std::numeric_limits<double>::infinity();
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
  const Vec3 about = parallel ? across(along) : normalized(off, across(along));
  const Vec3 normal = normalized(about - dot(about, along) * along, across(along));
  box.axis[0] = along;
  box.axis[1] = normalized(cross(normal, along), across(along));
  box.axis[2] = normal;
}

}  // namespace

namespace {

bool is_skew(const Vec3 (&axis)[3]) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j <= i; ++j)
      if (!(std::abs(dot(axis[i], axis[j]) - (i == j ? 1 : 0)) <= most_skew / 2)) return true;
  return false;
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
  slack = is_skew(axis) ? std::numeric_limits<double>::infinity() : left + slack_for(reach);
}

OrientedBox::OrientedBox(const Box& box) {
  const Vec3 low{box.low[0], box.low[1], box.low[2]}, high{box.high[0], box.high[1], box.high[2]};
  centre = 0.5 * (low + high);
  const Vec3 half = 0.5 * (high - low);
  axis[0] = {1, 0, 0};
  axis[1] = {0, 1, 0};
  axis[2] = {0, 0, 1};
  extent[0] = half.x;
  extent[1] = half.y;
  extent[2] = half.z;
  slack = slack_for(max_norm(centre) + max_norm(half));
}

// Fifteen axes: those of both boxes and their products, with `between` as seen along the axes of a,
// and cosines of all pairs of axes. A slack is one for each coordinate; for a unit vector that
// makes less than twice as much.
bool apart(const OrientedBox& a, const OrientedBox& b) {
  const Vec3 between = b.centre - a.centre;
  const double slack = 2 * (a.slack + b.slack);
  double t[3], cosine[3][3], size[3][3];
  for (int i = 0; i < 3; ++i) {
    t[i] = dot(between, a.axis[i]);
    for (int j = 0; j < 3; ++j) {
      cosine[i][j] = dot(a.axis[i], b.axis[j]);
      size[i][j] = std::abs(cosine[i][j]);
    }
    if (std::abs(t[i]) > a.extent[i] + b.extent[0] * size[i][0] + b.extent[1] * size[i][1] +
                             b.extent[2] * size[i][2] + slack)
      return true;
  }
  for (int j = 0; j < 3; ++j)
    if (std::abs(dot(between, b.axis[j])) > b.extent[j] + a.extent[0] * size[0][j] +
                                                a.extent[1] * size[1][j] +
                                                a.extent[2] * size[2][j] + slack)
      return true;
  constexpr int after[3] = {1, 2, 0}, before[3] = {2, 0, 1};
  for (int i = 0; i < 3; ++i) {
    const int k = after[i], l = before[i];
    for (int j = 0; j < 3; ++j) {
      const int m = after[j], n = before[j];
      if (std::abs(t[l] * cosine[k][j] - t[k] * cosine[l][j]) >
          a.extent[k] * size[l][j] + a.extent[l] * size[k][j] + b.extent[m] * size[i][n] +
              b.extent[n] * size[i][m] + slack)
        return true;
    }
  }
  return false;
}

// Where the line does not meet the box, anything is right.
double begin_along_x(const OrientedBox& box, const Vec3& start) {
  const Vec3 between = box.centre - start;
  double begin = 0;
  for (int i = 0; i < 3; ++i) {
    const double speed = box.axis[i].x, away = dot(box.axis[i], between);
    if (speed == 0) continue;
    begin = std::max(begin, ((speed < 0 ? -away : away) - box.extent[i]) / std::abs(speed));
  }
  return start.x + begin;
}

// By half their surfaces.
bool are_mostly_empty(std::span<const Box> boxes) {
  constexpr double many_times = 4;
  constexpr std::size_t few = threshold(32, 2);
  if (boxes.size() < few) return false;
  const auto surface = [](const Box& b) {
    const double x = double(b.high[0]) - double(b.low[0]), y = double(b.high[1]) - double(b.low[1]),
                 z = double(b.high[2]) - double(b.low[2]);
    return x * y + y * z + z * x;
  };
  Box all;
  double sum = 0;
  for (const Box& b : boxes) {
    all.add(b);
    sum += surface(b);
  }
  return sum > many_times * surface(all);
}

}  // namespace sectile
