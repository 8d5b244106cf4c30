// Placements that bring a point exactly where it is wanted.
#include <algorithm>
#include <bit>
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

// Doubles in their order, so that neighbours differ by one.
std::int64_t place_of(double value) {
  const auto bits = std::bit_cast<std::int64_t>(value);
  return bits >= 0 ? bits : std::numeric_limits<std::int64_t>::min() - bits;
}
double double_at(std::int64_t place) {
  return std::bit_cast<double>(place >= 0 ? place
                                          : std::numeric_limits<std::int64_t>::min() - place);
}

/// A solid inside a node, seen from the world.
struct Chain {
  const Transform& parent;
  const Transform& below;
  const Vec3& local;

  // Composed as Scene::world and the evaluator do it, with the same roundings.
  Vec3 image(const Placement& placement) const {
    Transform own = placement.transform();
    if (!is_identity(parent)) own = parent * own;
    if (!is_identity(below)) own = own * below;
    return own(local);
  }
  double slope(int axis, int i) const { return parent.m[static_cast<std::size_t>(4 * axis + i)]; }
};

/// For each coordinate of the world one of the position, so that those that are wanted have one
/// each that moves them much.
std::array<int, 3> movers(const Chain& chain, const std::array<bool, 3>& fixed) {
  std::array<int, 3> order{0, 1, 2}, best = order;
  double strength = -1;
  do {
    double product = 1;
    for (int axis = 0; axis < 3; ++axis)
      if (fixed[static_cast<std::size_t>(axis)])
        product *= std::abs(chain.slope(axis, order[static_cast<std::size_t>(axis)]));
    if (product > strength) strength = product, best = order;
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

/// Coordinates of the world grow with those of the position, if not always at each step: halving
/// finds the position that gives what is wanted, or two neighbours between whose images it lies.
class Refinement {
 public:
  Refinement(Placement& placement, const Chain& chain, int axis, int i, double wanted)
      : placement_(placement),
        chain_(chain),
        axis_(axis),
        i_(i),
        is_rising_(chain.slope(axis, i) > 0),
        wanted_(wanted) {}

  void run() {
    const double start = coordinate(placement_.position, i_), error = error_at(start);
    if (error == 0 || chain_.slope(axis_, i_) == 0) return;
    const double way = (error < 0) == is_rising_ ? 1 : -1;
    const double largest = std::max({std::abs(start), std::abs(wanted_), std::abs(error)});
    double near = start, far = start, step = std::nextafter(largest, infinite) - largest;
    for (double there = error; is_like(there, error); step *= 2) {
      if (!std::isfinite(there)) return give_back(start);
      near = far;
      far = start + way * step;
      there = error_at(far);
    }
    halve(place_of(near), place_of(far), error);
  }

 private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();

  static bool is_like(double a, double b) { return a != 0 && (a < 0) == (b < 0); }

  void halve(std::int64_t near, std::int64_t far, double error) {
    while (std::abs(far - near) > 1) {
      const std::int64_t middle = near + (far - near) / 2;
      (is_like(error_at(double_at(middle)), error) ? near : far) = middle;
    }
    const double a = double_at(near), b = double_at(far);
    give_back(std::abs(error_at(a)) < std::abs(error_at(b)) ? a : b);
  }

  void give_back(double value) { coordinate(placement_.position, i_) = value; }

  double error_at(double value) {
    give_back(value);
    return coordinate(chain_.image(placement_), axis_) - wanted_;
  }

  Placement& placement_;
  const Chain& chain_;
  int axis_, i_;
  bool is_rising_;
  double wanted_;
};

bool reaches(const Chain& chain, const Placement& placement, const Vec3& target,
             const std::array<bool, 3>& fixed) {
  const Vec3 reached = chain.image(placement);
  for (int axis = 0; axis < 3; ++axis)
    if (fixed[static_cast<std::size_t>(axis)] &&
        coordinate(reached, axis) != coordinate(target, axis))
      return false;
  return true;
}

glm::dvec3 in_parent(const Transform& parent, const glm::dvec3& step) {
  return glm::dmat3(matrix_of(inverse(parent))) * step;
}

}  // namespace

Landing moved_onto(const Placement& start, const Transform& parent, const Vec3& local,
                   const Vec3& target, const std::array<bool, 3>& fixed, const Transform& below) {
  const Chain chain{parent, below, local};
  Placement made = start;
  const Vec3 now = chain.image(start);
  glm::dvec3 step(0);
  for (int i = 0; i < 3; ++i)
    if (fixed[static_cast<std::size_t>(i)]) step[i] = coordinate(target, i) - coordinate(now, i);
  const glm::dvec3 own = in_parent(parent, step);
  for (int i = 0; i < 3; ++i) coordinate(made.position, i) += own[i];
  // In a parent that is turned, one coordinate of the position moves several of the world: then
  // later ones disturb those before, less each time.
  const std::array<int, 3> by = movers(chain, fixed);
  for (int sweep = 0; sweep < 4 && !reaches(chain, made, target, fixed); ++sweep)
    for (int axis = 0; axis < 3; ++axis)
      if (fixed[static_cast<std::size_t>(axis)])
        Refinement(made, chain, axis, by[static_cast<std::size_t>(axis)], coordinate(target, axis))
            .run();
  return {made, reaches(chain, made, target, fixed)};
}

Landing placed_by(const Placement& start, const Transform& parent, const Vec3& offset,
                  const std::vector<Snap>& contacts,
                  const std::vector<std::optional<Transform>>& below) {
  const glm::dvec3 own =
      in_parent(parent, to_glm(contacts.empty() ? offset : contacts.back().offset));
  Landing made{start, true};
  Vec3& position = made.placement.position;
  position = {position.x + own.x, position.y + own.y, position.z + own.z};
  for (const Snap& contact : contacts) {
    const std::optional<Transform>& inner = below.at(contact.part);
    if (!inner) continue;
    const Transform before = parent * start.transform() * *inner;
    const Vec3 local = contact.local ? *contact.local : inverse(before)(contact.from);
    const Landing next =
        moved_onto(made.placement, parent, local, contact.to, contact.fixed, *inner);
    made = {next.placement, made.is_exact && next.is_exact && contact.is_expressible};
  }
  return made;
}

}  // namespace sectile::viewer
