#include "scene/exact_moves.h"

#include <glm/glm.hpp>

#include "scene/transforms.h"

namespace sectile::viewer {

namespace {

double& coordinate(Vec3& v, int i) {
  return i == 0 ? v.x : i == 1 ? v.y : v.z;
}

Vec3 in_parent(const Transform& parent, const Vec3& step) {
  return from_glm(glm::dmat3(matrix_of(inverse(parent))) * to_glm(step));
}

}  // namespace

ExactSum& ExactSum::add(const ExactTransform& place, const ExactCorner& corner, double factor) {
  terms_.push_back({place, corner, factor});
  return *this;
}

ExactSum& ExactSum::add(const ExactSum& more, double factor) {
  for (const Term& term : more.terms_)
    terms_.push_back({term.place, term.corner, term.factor * factor});
  return *this;
}

ExactSum ExactSum::mapped(const ExactTransform& by) const {
  ExactSum made = *this;
  for (Term& term : made.terms_) term.place = by * term.place;
  return made;
}

// M·(near + rest) + t is the image of near and that of rest less that of the origin.
Vec3 ExactSum::value() const {
  std::vector<WeightedImage> images;
  for (const Term& term : terms_) {
    images.push_back({term.place, term.corner.near, term.factor});
    if (term.corner.rest == Vec3{0, 0, 0}) continue;
    images.push_back({term.place, term.corner.rest, term.factor});
    images.push_back({term.place, {0, 0, 0}, -term.factor});
  }
  return sum_of_images(images);
}

bool ExactSum::is_known(int axis) const {
  for (const Term& term : terms_) {
    if (term.corner.is_exact == Coordinates{true, true, true}) continue;
    const Transform place = term.place.nearest();
    for (std::size_t k = 0; k < 3; ++k)
      if (!term.corner.is_exact[k] && place.m[static_cast<std::size_t>(4 * axis) + k] != 0)
        return false;
  }
  return true;
}

bool are_equal(const ExactSum& a, const ExactSum& b, const Coordinates& axes) {
  Vec3 difference = ExactSum(a).add(b, -1).value();
  for (int i = 0; i < 3; ++i)
    if (axes[static_cast<std::size_t>(i)] &&
        (coordinate(difference, i) != 0 || !a.is_known(i) || !b.is_known(i)))
      return false;
  return true;
}

// What is missing is known exactly but for one rounding: each step leaves 2^-50 of it, until it is
// nothing or less than the placement can hold.
Landing moved_onto(const Placement& start, const ExactTransform& parent, const ExactSum& own,
                   const ExactSum& target, const Coordinates& axes) {
  Landing made{start, false};
  const Transform rounded_parent = parent.nearest();
  for (int step = 0; step < 8; ++step) {
    const ExactSum reached = own.mapped(parent * made.placement.exact());
    Vec3 missing = ExactSum(target).add(reached, -1).value();
    for (int i = 0; i < 3; ++i)
      if (!axes[static_cast<std::size_t>(i)]) coordinate(missing, i) = 0;
    if (missing == Vec3{0, 0, 0}) {
      made.is_exact = are_equal(reached, target, axes);
      break;
    }
    const Placement before = made.placement;
    made.placement.move(in_parent(rounded_parent, missing));
    if (made.placement == before) break;
  }
  return made;
}

Shift shift_between(const Placement& from, const Placement& to) {
  Placement difference;
  difference.move(to.position);
  for (const Vec3& less : {from.position, from.remainder})
    difference.move({-less.x, -less.y, -less.z});
  difference.move(to.remainder);
  return {difference.position, difference.remainder};
}

Placement shifted(const Placement& start, const Shift& shift) {
  Placement made = start;
  made.move(shift.by);
  made.move(shift.rest);
  return made;
}

Placement carried_over(const Placement& placement, const ExactTransform& from,
                       const ExactTransform& to) {
  const Transform map = inverse(to.nearest()) * from.nearest() * placement.transform();
  const ExactSum origin = ExactSum::of({0, 0, 0});
  return moved_onto(Placement::of(map), to, origin, origin.mapped(from * placement.exact()))
      .placement;
}

}  // namespace sectile::viewer
