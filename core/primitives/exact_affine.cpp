#include "primitives/exact_affine.h"

#include <cmath>

#include "primitives/arguments.h"

namespace sectile {

namespace {

bool all_finite(const double a[4], const double b[4]) {
  for (int i = 0; i < 4; ++i)
    if (!std::isfinite(a[i]) || !std::isfinite(b[i])) return false;
  return true;
}

double exactly_rounded_dot(const double a[4], const double b[4]) {
  Dyadic sum;
  for (int i = 0; i < 4; ++i) sum = sum + Dyadic(a[i]) * Dyadic(b[i]);
  return sum.nearest();
}

}  // namespace

// Products and sums with their errors; the errors are added in doubles. Beside the exact value this
// is wrong by less than 64 units of 2^-106 of the magnitude, 2^-99 with room to spare.
double rounded_dot(const double a[4], const double b[4]) {
  double sum = 0, rest = 0, magnitude = 0;
  for (int i = 0; i < 4; ++i) {
    const double product = a[i] * b[i];
    const double product_error = std::fma(a[i], b[i], -product);
    const double next = sum + product;
    const double part = next - sum;
    const double sum_error = (sum - (next - part)) + (product - part);
    rest += product_error + sum_error;
    sum = next;
    magnitude += std::fabs(product);
  }
  // Far from overflow, and so far from underflow that lost bits of products do not count.
  if (magnitude > 0x1p-800 && magnitude < 0x1p1000) {
    const double bound = magnitude * 0x1p-99;
    const double low = sum + (rest - bound), high = sum + (rest + bound);
    if (low == high) return low;
  }
  if (!all_finite(a, b)) return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  return exactly_rounded_dot(a, b);
}

ExactAffine::ExactAffine(const Transform& transform) : transform_(transform) {
  for (const double m : transform.m)
    require(std::isfinite(m), "The matrix of a transform must be finite.");
  for (int i = 0; i < 12; ++i) entries_[i] = Dyadic(transform.m[i]);
  for (int row = 0; row < 3; ++row) {
    const int r = (row + 1) % 3, s = (row + 2) % 3;
    for (int column = 0; column < 3; ++column) {
      const int c = (column + 1) % 3, d = (column + 2) % 3;
      cofactors_[3 * row + column] = entry(r, c) * entry(s, d) - entry(r, d) * entry(s, c);
    }
  }
  for (int column = 0; column < 3; ++column)
    determinant_ = determinant_ + entry(0, column) * cofactors_[column];
  require(determinant_.sign() != Sign::zero,
          "The matrix of the transform is singular: it would flatten the solid.");
}

Vec3 ExactAffine::rounded(const ExactPoint& p) const {
  double image[3];
  for (int row = 0; row < 3; ++row) {
    const Dyadic numerator = entry(row, 0) * p.x[0] + entry(row, 1) * p.x[1] +
                             entry(row, 2) * p.x[2] + entry(row, 3) * p.w;
    image[row] = nearest_quotient(numerator, p.w);
  }
  return {image[0], image[1], image[2]};
}

bool ExactAffine::map(const Vec3& point, Vec3& image) const {
  image = transform_(point);
  const double images[] = {image.x, image.y, image.z};
  for (int row = 0; row < 3; ++row) {
    if (!std::isfinite(images[row])) return false;
    const double* m = &transform_.m[4 * row];
    const double a[] = {m[0], m[1], m[2], m[3], -1};
    const double b[] = {point.x, point.y, point.z, 1, images[row]};
    if (sign_of_dot(a, b, 5) != Sign::zero) return false;
  }
  return true;
}

// With the cofactors C of the linear part L and its determinant D, C·n = D·L^-T·n; a mirroring map
// has a negative D and the sign is turned back.
bool ExactAffine::map(const PlaneCoefficients& plane, PlaneCoefficients& image) const {
  const Dyadic n[] = {Dyadic(plane.a), Dyadic(plane.b), Dyadic(plane.c)};
  Dyadic exact[4];
  exact[3] = determinant_ * Dyadic(plane.d);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      exact[row] = exact[row] + cofactors_[3 * row + column] * n[column];
    exact[3] = exact[3] - exact[row] * entry(row, 3);
  }
  double rounded[4];
  for (int i = 0; i < 4; ++i) {
    if (mirrors()) exact[i] = -exact[i];
    rounded[i] = exact[i].nearest();
    if (!std::isfinite(rounded[i]) || (exact[i] - Dyadic(rounded[i])).sign() != Sign::zero)
      return false;
  }
  image = {rounded[0], rounded[1], rounded[2], rounded[3]};
  return true;
}

int ExactAffine::axis_image(int axis, bool& reversed) const {
  int found = -1;
  for (int row = 0; row < 3; ++row) {
    const double value = transform_.m[4 * row + axis];
    if (value == 0) continue;
    if (found >= 0) return -1;
    found = row;
    reversed = value < 0;
  }
  return found;
}

}  // namespace sectile
