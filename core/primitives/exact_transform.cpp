#include "sectile/exact_transform.h"

#include <cmath>
#include <limits>

#include "geometry/axes.h"
#include "geometry/frame.h"
#include "primitives/arguments.h"
#include "primitives/checked_frame.h"
#include "storage/moved_solid.h"

namespace sectile {
namespace {

Dyadic coordinate_of(const WeightedImage& image, int row) {
  if (image.transform.is_identity()) return Dyadic(component(image.point, row));
  const Frame& frame = *image.transform.frame();
  Dyadic sum = frame.exact(row, 3);
  for (int k = 0; k < 3; ++k) sum += frame.exact(row, k) * Dyadic(component(image.point, k));
  return sum;
}

bool is_double(const Dyadic& value) {
  const double near = value.nearest();
  return std::isfinite(near) && Dyadic(near) == value;
}

/// The inverse of the matrix without its move, if both are matrices of doubles.
std::optional<Transform> inverse_of_matrix(const Frame& frame) {
  const Dyadic determinant = frame.determinant();
  if (determinant.sign() == Sign::zero) return {};
  const std::int64_t power = determinant.magnitude();
  if (!(determinant.scaled(-power) == Dyadic(determinant.sign() == Sign::negative ? -1.0 : 1.0)))
    return {};
  Transform made;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) {
      Dyadic entry = frame.cofactor(column, row).scaled(-power);
      if (determinant.sign() == Sign::negative) entry = -entry;
      if (!is_double(frame.exact(row, column)) || !is_double(entry)) return {};
      made.m[static_cast<std::size_t>(4 * row + column)] = entry.nearest();
    }
  return made;
}

}  // namespace

ExactTransform::ExactTransform() = default;

ExactTransform::ExactTransform(const Transform& transform) {
  for (const double m : transform.m)
    require(std::isfinite(m), "The matrix of a transform must be finite.");
  Frame frame(transform.m);
  if (!frame.is_identity()) frame_ = std::make_shared<const Frame>(std::move(frame));
}

ExactTransform operator*(const ExactTransform& second, const ExactTransform& first) {
  if (first.is_identity()) return second;
  if (second.is_identity()) return first;
  Frame product = *second.frame_ * *first.frame_;
  if (product.is_identity()) return {};
  return ExactTransform(std::make_shared<const Frame>(std::move(product)));
}

bool operator==(const ExactTransform& a, const ExactTransform& b) {
  if (a.frame_ == b.frame_) return true;
  if (a.is_identity() || b.is_identity()) return false;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      if (!(a.frame_->exact(row, column) == b.frame_->exact(row, column))) return false;
  return true;
}

Transform ExactTransform::nearest() const {
  Transform made;
  for (int row = 0; frame_ && row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      made.m[static_cast<std::size_t>(4 * row + column)] = frame_->exact(row, column).nearest();
  return made;
}

// (M·p + t) back: M⁻¹·(p - t). The move is taken off double by double until nothing is left.
std::optional<ExactTransform> ExactTransform::inverse() const {
  if (is_identity()) return ExactTransform();
  const std::optional<Transform> matrix = inverse_of_matrix(*frame_);
  if (!matrix) return {};
  ExactTransform back;
  Dyadic left[3] = {frame_->exact(0, 3), frame_->exact(1, 3), frame_->exact(2, 3)};
  for (;;) {
    Vec3 by;
    for (int k = 0; k < 3; ++k) {
      component(by, k) = -left[k].nearest();
      if (!std::isfinite(component(by, k))) return {};
      left[k] += Dyadic(component(by, k));
    }
    if (by == Vec3{0, 0, 0}) break;  // or too small for doubles
    back = ExactTransform(Transform::translation(by)) * back;
  }
  for (const Dyadic& rest : left)
    if (rest.sign() != Sign::zero) return {};
  return ExactTransform(*matrix) * back;
}

Solid transformed(const Solid& solid, const ExactTransform& transform) {
  if (transform.is_identity()) return solid;
  require_invertible(*transform.frame());
  if (solid.is_empty()) return solid;
  const MovedSolid* before = solid.moved();
  const auto& original = before ? before->original() : solid.data();
  const Frame all = before ? *transform.frame() * before->frame() : *transform.frame();
  if (all.is_identity()) return Solid(original);
  return Solid(std::make_shared<const MovedSolid>(original, all));
}

Vec3 sum_of_images(std::span<const WeightedImage> images) {
  Vec3 made;
  for (int row = 0; row < 3; ++row) {
    Dyadic sum;
    for (const WeightedImage& image : images)
      sum += Dyadic(image.factor) * coordinate_of(image, row);
    double& rounded = component(made, row);
    rounded = sum.nearest();
    if (rounded == 0 && sum.sign() != Sign::zero)
      rounded = std::copysign(std::numeric_limits<double>::denorm_min(),
                              sum.sign() == Sign::negative ? -1.0 : 1.0);
  }
  return made;
}

}  // namespace sectile
