#include "scene/placing.h"

#include <algorithm>
#include <cmath>

#include "scene/handles.h"
#include "scene/transforms.h"

namespace sectile::viewer {
namespace {

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
  const Transform world = start.parent.nearest() * start.placement.transform();
  handles.origin = {world.m[3], world.m[7], world.m[11]};
  return start.with(changed(start.placement, start.parent.nearest(), handles, change));
}

Landing moved_by(const Standing& standing, const glm::dvec3& by) {
  Landing made{standing.placement, false};
  made.placement.move(from_glm(glm::dmat3(matrix_of(inverse(standing.parent.nearest()))) * by));
  return made;
}

struct Range {
  double low = 1e300, high = -1e300;
  void add(double value) { low = std::min(low, value), high = std::max(high, value); }
  double middle() const { return 0.5 * low + 0.5 * high; }
};

Range range_along(const std::vector<Vec3>& points, const glm::dvec3& d) {
  Range range;
  for (const Vec3& p : points) range.add(glm::dot(to_glm(p), d));
  return range;
}

std::vector<Vec3> images(const Transform& map, const std::vector<ExactCorner>& corners) {
  std::vector<Vec3> made;
  for (const ExactCorner& p : corners) made.push_back(map(p.near));
  return made;
}

Coordinates only(int axis) {
  return {axis == 0, axis == 1, axis == 2};
}

/// A corner of a solid onto a point.
Landing onto(const Standing& standing, const ExactCorner& corner, const ExactSum& target,
             const Coordinates& axes) {
  return moved_onto(standing.placement, standing.parent, {standing.below, corner}, target, axes);
}

/// Do these corners of a solid lie at a point, as far as these coordinates go?
bool are_at(const ExactTransform& place, std::span<const ExactCorner> corners,
            const ExactSum& point, const Coordinates& axes) {
  return std::all_of(corners.begin(), corners.end(), [&](const ExactCorner& corner) {
    return are_equal({place, corner}, point, axes);
  });
}

ExactBox box_of(const Standing& standing, const std::vector<ExactCorner>& corners) {
  ExactBox box;
  box.add(standing, corners);
  return box;
}

/// Faces across an axis of the world: each coordinate by itself.
Landing flush_along(const Standing& turned, const FlatFace& moved, const FlatFace& fixed, int axis,
                    bool centre) {
  const ExactSum plane(fixed.place, fixed.corners.front());
  Landing made = onto(turned, moved.corners.front(), plane, only(axis));
  const ExactBox around = box_of({{}, fixed.place, {}}, fixed.corners);
  for (int i = 0; centre && i < 3; ++i) {
    if (i == axis) continue;
    const Landing next = centred(box_of(turned.with(made.placement), moved.corners), i,
                                 around.low(i).exact(), around.high(i).exact());
    made = {next.placement, made.is_exact && next.is_exact};
  }
  // Turns by other than right angles leave the corners in a plane only nearly.
  made.is_exact = made.is_exact && are_at(fixed.place, fixed.corners, plane, only(axis)) &&
                  are_at(turned.with(made.placement).exact_map(), moved.corners, plane, only(axis));
  return made;
}

}  // namespace

Transform Standing::map() const {
  return exact_map().nearest();
}

ExactTransform Standing::exact_map() const {
  return parent * placement.exact() * below;
}

Landing flush(const Standing& start, const FlatFace& moved, const FlatFace& fixed,
              const FlushOptions& options) {
  const glm::dvec3 n = to_glm(fixed.normal);
  const glm::dvec3 wanted = options.same_side ? n : -n;
  const Standing standing = turned(start, to_glm(moved.normal), wanted);
  if (const std::optional<int> axis = axis_along(n))
    return flush_along(standing, moved, fixed, *axis, options.centred);
  const std::vector<Vec3> corners = images(standing.map(), moved.corners);
  const std::vector<Vec3> there = images(fixed.place.nearest(), fixed.corners);
  glm::dvec3 by = n * (range_along(there, n).middle() - range_along(corners, n).middle());
  if (options.centred) {
    const glm::dvec3 u = across(n), v = glm::cross(n, u);
    for (const glm::dvec3& d : {u, v})
      by += d * (range_along(there, d).middle() - range_along(corners, d).middle());
  }
  return moved_by(standing, by);
}

Landing edge_on_edge(const Standing& start, const PlacedEdge& moved, const PlacedEdge& fixed) {
  const Transform there = fixed.place.nearest();
  const glm::dvec3 from = to_glm(start.image(moved.to.near)) - to_glm(start.image(moved.from.near));
  const glm::dvec3 to = to_glm(there(fixed.to.near)) - to_glm(there(fixed.from.near));
  const Standing standing = turned(start, glm::normalize(from), glm::normalize(to));
  const ExactSum begin(fixed.place, fixed.from), end(fixed.place, fixed.to);
  Landing made = onto(standing, moved.from, begin, {true, true, true});
  const ExactSum reached(standing.with(made.placement).exact_map(), moved.to);
  // On a line along an axis any point will do, on others the end.
  const std::optional<int> axis = axis_along(glm::normalize(to));
  Coordinates across{true, true, true};
  if (axis) across[static_cast<std::size_t>(*axis)] = false;
  const bool on_line = axis && are_equal(begin, end, across) && are_equal(reached, end, across);
  made.is_exact = made.is_exact && (on_line || are_equal(reached, end, {true, true, true}));
  return made;
}

ExactSum ExactBox::Side::exact() const {
  return {standing.exact_map(), corner};
}

namespace {

double sum_of_sizes(const Vec3& p) {
  return std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
}

/// An upper bound for what the images of a corner of this size lose by rounding.
double doubt_of(const Transform& map, const Vec3& corner) {
  double largest = 0, move = 0;
  for (std::size_t i = 0; i < 12; ++i)
    (i % 4 == 3 ? move : largest) = std::max(i % 4 == 3 ? move : largest, std::abs(map.m[i]));
  return 0x1p-50 * (largest * sum_of_sizes(corner) + move);
}

bool is_farther(const ExactBox::Side& side, const std::optional<ExactBox::Side>& than, int axis,
                double sign) {
  if (!than) return true;
  const double by = sign * (side.value - than->value);
  if (std::abs(by) > side.doubt + than->doubt) return by > 0;
  return sign * coordinate(side.exact().add(than->exact(), -1).value(), axis) > 0;
}

}  // namespace

void ExactBox::add(const Standing& standing, std::span<const ExactCorner> corners) {
  const Transform map = standing.map();
  for (const ExactCorner& corner : corners) {
    const Vec3 p = map(corner.near);
    Side side{standing, corner, 0, doubt_of(map, corner.near)};
    for (int i = 0; i < 3; ++i) {
      side.value = coordinate(p, i);
      auto& lowest = low_[static_cast<std::size_t>(i)];
      auto& highest = high_[static_cast<std::size_t>(i)];
      if (is_farther(side, lowest, i, -1)) lowest = side;
      if (is_farther(side, highest, i, 1)) highest = side;
    }
  }
}

Landing aligned(const ExactBox& box, int axis, BoxPlace place, const ExactSum& value) {
  if (place == BoxPlace::centre) return centred(box, axis, value, value);
  const ExactBox::Side& side = place == BoxPlace::low ? box.low(axis) : box.high(axis);
  return onto(side.standing, side.corner, value, only(axis));
}

Landing centred(const ExactBox& box, int axis, const ExactSum& low, const ExactSum& high) {
  const ExactBox::Side &a = box.low(axis), &b = box.high(axis);
  ExactSum middle, wanted;
  middle.add(a.standing.below, a.corner, 0.5).add(b.standing.below, b.corner, 0.5);
  wanted.add(low, 0.5).add(high, 0.5);
  return moved_onto(a.standing.placement, a.standing.parent, middle, wanted, only(axis));
}

}  // namespace sectile::viewer
