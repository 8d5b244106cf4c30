#include "scene/placing.h"

#include <algorithm>
#include <cmath>

#include "scene/handles.h"
#include "scene/transforms.h"

namespace sectile::viewer {
namespace {

double& coordinate(Vec3& v, int i) {
  return i == 0 ? v.x : i == 1 ? v.y : v.z;
}
double coordinate(const Vec3& v, int i) {
  return i == 0 ? v.x : i == 1 ? v.y : v.z;
}

/// The axis along which a unit vector points, up to rounding.
std::optional<int> axis_along(const glm::dvec3& d) {
  for (int i = 0; i < 3; ++i)
    if (std::abs(d[i]) > 1 - 1e-12) return i;
  return std::nullopt;
}

/// Any direction at right angles, along an axis if there is one.
glm::dvec3 across(const glm::dvec3& d) {
  int flattest = 2;
  for (const int i : {1, 0})
    if (std::abs(d[i]) < std::abs(d[flattest])) flattest = i;
  glm::dvec3 axis(0);
  axis[flattest] = 1;
  return glm::normalize(axis - d * glm::dot(axis, d));
}

/// Angles come from coordinates with rounding: within that, a round one was meant.
double tidy_degrees(double radians) {
  const double degrees = glm::degrees(radians), round = std::round(degrees * 64) / 64;
  return std::abs(degrees - round) < 1e-9 ? round : degrees;
}

/// Turned about the node's origin so that the direction `from` of the world becomes `to`.
Standing turned(const Standing& start, const glm::dvec3& from, const glm::dvec3& to) {
  const glm::dvec3 normal = glm::cross(from, to);
  const double sine = glm::length(normal);
  HandleChange change;
  change.degrees = tidy_degrees(std::atan2(sine, glm::dot(from, to)));
  if (change.degrees == 0) return start;
  change.axis = sine > 1e-9 ? normal / sine : across(from);
  Handles handles;
  const Transform world = start.parent * start.placement.transform();
  handles.origin = {world.m[3], world.m[7], world.m[11]};
  return start.with(changed(start.placement, start.parent, handles, change));
}

Landing moved_by(const Standing& standing, const glm::dvec3& by) {
  Landing made{standing.placement, false};
  const glm::dvec3 own = glm::dmat3(matrix_of(inverse(standing.parent))) * by;
  Vec3& p = made.placement.position;
  p = {p.x + own.x, p.y + own.y, p.z + own.z};
  return made;
}

struct Range {
  double low = 1e300, high = -1e300;
  void add(double value) { low = std::min(low, value), high = std::max(high, value); }
  double middle() const { return 0.5 * low + 0.5 * high; }
};

/// a + b with what the sum loses; the same sums have the same pairs.
std::pair<double, double> exact_sum(double a, double b) {
  const double sum = a + b, part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

Range range_along(const std::vector<Vec3>& points, const glm::dvec3& d) {
  Range range;
  for (const Vec3& p : points) range.add(glm::dot(to_glm(p), d));
  return range;
}

std::vector<Vec3> images(const Standing& standing, const std::vector<Vec3>& local) {
  const Transform map = standing.map();
  std::vector<Vec3> made;
  for (const Vec3& p : local) made.push_back(map(p));
  return made;
}

/// Along one axis: a point of a solid onto a value.
Landing onto(const Standing& standing, const Vec3& local, int axis, double value) {
  Vec3 target = standing.image(local);
  coordinate(target, axis) = value;
  std::array<bool, 3> fixed{false, false, false};
  fixed[static_cast<std::size_t>(axis)] = true;
  return moved_onto(standing.placement, standing.parent, local, target, fixed, standing.below);
}

/// Along one axis: the middle of some points of a solid into the middle of a range.
Landing middle_onto(const Standing& standing, const std::vector<Vec3>& local, int axis,
                    const Range& wanted) {
  const Transform map = standing.map();
  const auto low = std::min_element(local.begin(), local.end(), [&](const Vec3& a, const Vec3& b) {
    return coordinate(map(a), axis) < coordinate(map(b), axis);
  });
  glm::dvec3 d(0);
  d[axis] = 1;
  const Range now = range_along(images(standing, local), d);
  Landing made = onto(standing, *low, axis, now.low + (wanted.middle() - now.middle()));
  const Range then = range_along(images(standing.with(made.placement), local), d);
  made.is_exact = exact_sum(then.low, then.high) == exact_sum(wanted.low, wanted.high);
  return made;
}

/// Faces across an axis of the world: each coordinate by itself.
Landing flush_along(const Standing& turned, const FlatFace& moved, const FlatFace& fixed, int axis,
                    bool centred) {
  Landing made = onto(turned, moved.corners.front(), axis, coordinate(fixed.corners.front(), axis));
  for (int i = 0; centred && i < 3; ++i) {
    if (i == axis) continue;
    glm::dvec3 d(0);
    d[i] = 1;
    const Landing next =
        middle_onto(turned.with(made.placement), moved.corners, i, range_along(fixed.corners, d));
    made = {next.placement, made.is_exact && next.is_exact};
  }
  // Turns by other than right angles leave the corners in a plane only nearly.
  const Transform landed = turned.with(made.placement).map();
  for (const Vec3& corner : moved.corners)
    if (coordinate(landed(corner), axis) != coordinate(fixed.corners.front(), axis))
      made.is_exact = false;
  return made;
}

}  // namespace

Transform Standing::map() const {
  Transform own = placement.transform();
  if (!is_identity(parent)) own = parent * own;
  if (!is_identity(below)) own = own * below;
  return own;
}

Landing flush(const Standing& start, const FlatFace& moved, const FlatFace& fixed,
              const FlushOptions& options) {
  const glm::dvec3 n = to_glm(fixed.normal);
  const glm::dvec3 wanted = options.same_side ? n : -n;
  const Standing standing = turned(start, to_glm(moved.normal), wanted);
  if (const std::optional<int> axis = axis_along(n))
    return flush_along(standing, moved, fixed, *axis, options.centred);
  const std::vector<Vec3> corners = images(standing, moved.corners);
  glm::dvec3 by = n * (range_along(fixed.corners, n).middle() - range_along(corners, n).middle());
  if (options.centred) {
    const glm::dvec3 u = across(n), v = glm::cross(n, u);
    for (const glm::dvec3& d : {u, v})
      by += d * (range_along(fixed.corners, d).middle() - range_along(corners, d).middle());
  }
  return moved_by(standing, by);
}

Landing edge_on_edge(const Standing& start, const PlacedEdge& moved, const PlacedEdge& fixed) {
  const glm::dvec3 from = to_glm(start.image(moved.to)) - to_glm(start.image(moved.from));
  const glm::dvec3 to = to_glm(fixed.to) - to_glm(fixed.from);
  const Standing standing = turned(start, glm::normalize(from), glm::normalize(to));
  Landing made = moved_onto(standing.placement, standing.parent, moved.from, fixed.from,
                            {true, true, true}, standing.below);
  const Vec3 end = standing.with(made.placement).image(moved.to);
  const std::optional<int> axis = axis_along(glm::normalize(to));
  bool on_line = axis.has_value();
  for (int i = 0; i < 3; ++i)
    if (axis != i) on_line = on_line && coordinate(end, i) == coordinate(fixed.to, i);
  made.is_exact = made.is_exact && (on_line || end == fixed.to);
  return made;
}

void ExactBox::add(const Standing& standing, std::span<const Vec3> points) {
  const Transform map = standing.map();
  for (const Vec3& local : points) {
    const Vec3 p = map(local);
    for (int i = 0; i < 3; ++i) {
      const double value = coordinate(p, i);
      auto& lowest = low[static_cast<std::size_t>(i)];
      auto& highest = high[static_cast<std::size_t>(i)];
      if (!lowest || value < lowest->value) lowest = {standing, local, value};
      if (!highest || value > highest->value) highest = {standing, local, value};
    }
  }
}

Landing aligned(const ExactBox& box, int axis, BoxPlace place, double value) {
  if (place == BoxPlace::centre) return centred(box, axis, value, value);
  const auto& side = (place == BoxPlace::low ? box.low : box.high)[static_cast<std::size_t>(axis)];
  return onto(side->standing, side->local, axis, value);
}

Landing centred(const ExactBox& box, int axis, double low, double high) {
  const auto& a = *box.low[static_cast<std::size_t>(axis)];
  const auto& b = *box.high[static_cast<std::size_t>(axis)];
  const double by = (0.5 * low + 0.5 * high) - (0.5 * a.value + 0.5 * b.value);
  Landing made = onto(a.standing, a.local, axis, a.value + by);
  const double new_low = coordinate(a.standing.with(made.placement).image(a.local), axis);
  const double new_high = coordinate(b.standing.with(made.placement).image(b.local), axis);
  made.is_exact = exact_sum(new_low, new_high) == exact_sum(low, high);
  return made;
}

}  // namespace sectile::viewer
