// Placements that bring a point exactly where it is wanted.
#include <cmath>
#include <glm/glm.hpp>
#include <limits>

#include "scene/snapping.h"
#include "scene/transforms.h"

namespace sectile::viewer {

namespace {

double& coordinate(Vec3& v, int i) {
  return i == 0 ? v.x : i == 1 ? v.y : v.z;
}
double coordinate(const Vec3& v, int i) {
  return i == 0 ? v.x : i == 1 ? v.y : v.z;
}

/// The only coordinate of the world that position[i] changes, or -1.
int image_axis(const Transform& parent, int i) {
  int found = -1;
  for (int row = 0; row < 3; ++row)
    if (parent.m[static_cast<std::size_t>(4 * row + i)] != 0) {
      if (found >= 0) return -1;
      found = row;
    }
  return found;
}

Vec3 image(const Placement& placement, const Transform& parent, const Vec3& local) {
  const Transform own = placement.transform();
  return is_identity(parent) ? own(local) : (parent * own)(local);
}

/// Steps through neighbouring doubles until the image is the target. The first guess is off by the
/// roundings of the maps only.
void refine(Placement& placement, const Transform& parent, const Vec3& local, const Vec3& target,
            int i, int axis) {
  const double slope = parent.m[static_cast<std::size_t>(4 * axis + i)];
  double& p = coordinate(placement.position, i);
  const double wanted = coordinate(target, axis);
  double best = p;
  double best_error = std::abs(coordinate(image(placement, parent, local), axis) - wanted);
  for (int step = 0; step < 64 && best_error != 0; ++step) {
    const double now = coordinate(image(placement, parent, local), axis);
    const bool upwards = (now < wanted) == (slope > 0);
    const double next = p + (wanted - now) / slope;
    p = next != p ? next : std::nextafter(p, upwards ? HUGE_VAL : -HUGE_VAL);
    const double error = std::abs(coordinate(image(placement, parent, local), axis) - wanted);
    if (error >= best_error && step > 8) break;
    if (error < best_error) best = p, best_error = error;
  }
  p = best;
}

}  // namespace

Placement moved_onto(const Placement& start, const Transform& parent, const Vec3& local,
                     const Vec3& target, const std::array<bool, 3>& fixed) {
  Placement made = start;
  const Vec3 now = image(start, parent, local);
  glm::dvec3 step(0);
  for (int i = 0; i < 3; ++i)
    if (fixed[static_cast<std::size_t>(i)]) step[i] = coordinate(target, i) - coordinate(now, i);
  const glm::dvec3 own = glm::dvec3(matrix_of(inverse(parent)) * glm::dvec4(step, 0));
  for (int i = 0; i < 3; ++i) coordinate(made.position, i) += own[i];
  for (int i = 0; i < 3; ++i) {
    const int axis = image_axis(parent, i);
    if (axis >= 0 && fixed[static_cast<std::size_t>(axis)])
      refine(made, parent, local, target, i, axis);
  }
  return made;
}

Placement placed_by(const Placement& start, const Transform& parent, const Vec3& offset,
                    const std::vector<Snap>& snaps) {
  const Vec3 last = snaps.empty() ? offset : snaps.back().offset;
  const glm::dvec3 own =
      glm::dvec3(matrix_of(inverse(parent)) * glm::dvec4(last.x, last.y, last.z, 0));
  Placement made = start;
  made.position = {start.position.x + own.x, start.position.y + own.y, start.position.z + own.z};
  const Transform before = is_identity(parent) ? start.transform() : parent * start.transform();
  for (const Snap& snap : snaps)
    made = moved_onto(made, parent, snap.local ? *snap.local : inverse(before)(snap.from), snap.to,
                      snap.fixed);
  return made;
}

}  // namespace sectile::viewer
