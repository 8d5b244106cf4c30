#include "geometry/frame.h"

#include <cmath>
#include <utility>

#include "geometry/axes.h"
#include "numbers/rounding.h"

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

Bounded near(const Dyadic& value) {
  const double high = value.nearest();
  if (!std::isfinite(high)) return Bounded::within(0, std::numeric_limits<double>::infinity());
  const Dyadic rest = value - Dyadic(high);
  const double low = rest.nearest();
  if (rest == Dyadic(low)) return Bounded(high) + Bounded(low);
  return Bounded(high) + Bounded::within(low, rounding::unit * std::abs(low) + rounding::underflow);
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

ExactNumber::ExactNumber(Dyadic value) : exact_(std::move(value)), near_(sectile::near(exact_)) {}

Frame::Frame(const std::array<double, 12>& m) : doubles_(m), all_doubles_(true) {
  for (std::size_t i = 0; i < 12; ++i) entries_[i] = ExactNumber(Dyadic(m[i]));
}

Frame::Frame(const std::array<Dyadic, 12>& m) {
  for (std::size_t i = 0; i < 12; ++i) entries_[i] = ExactNumber(m[i]);
  find_doubles();
}

Frame operator*(const Frame& second, const Frame& first) {
  Frame product;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) {
      Dyadic sum = column == 3 ? second.exact(row, 3) : Dyadic();
      for (int k = 0; k < 3; ++k) sum += second.exact(row, k) * first.exact(k, column);
      product.entries_[static_cast<std::size_t>(4 * row + column)] = ExactNumber(std::move(sum));
    }
  product.find_doubles();
  return product;
}

void Frame::find_doubles() {
  all_doubles_ = true;
  for (std::size_t i = 0; i < 12; ++i) {
    doubles_[i] = entries_[i].exact().nearest();
    if (!std::isfinite(doubles_[i]) || !(Dyadic(doubles_[i]) == entries_[i].exact()))
      all_doubles_ = false;
  }
}

Dyadic Frame::cofactor(int row, int column) const {
  const int r = next_axis(row), s = next_next_axis(row), c = next_axis(column),
            d = next_next_axis(column);
  return exact(r, c) * exact(s, d) - exact(r, d) * exact(s, c);
}

Dyadic Frame::determinant() const {
  return exact(0, 0) * cofactor(0, 0) + exact(0, 1) * cofactor(0, 1) + exact(0, 2) * cofactor(0, 2);
}

bool Frame::is_identity() const {
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      if (!(exact(row, column) == Dyadic(row == column ? 1.0 : 0.0))) return false;
  return true;
}

bool Frame::round(const Vec3& local, Vec3& image) const {
  bool is_exact = true;
  if (all_doubles_) {
    const double p[] = {local.x, local.y, local.z, 1, 0};
    for (int row = 0; row < 3; ++row) {
      const double* m = &doubles_[static_cast<std::size_t>(4 * row)];
      const double value = rounded_dot(m, p);
      component(image, row) = value;
      if (!is_exact || !std::isfinite(value)) {
        is_exact = false;
        continue;
      }
      const double a[] = {m[0], m[1], m[2], m[3], -1}, b[] = {p[0], p[1], p[2], 1, value};
      is_exact = sign_of_dot(a, b, 5) == Sign::zero;
    }
    return is_exact;
  }
  Bounded near[3];
  map(local, near);
  for (int row = 0; row < 3; ++row) {
    const double high = near[row].high(), low = near[row].low(), error = near[row].error();
    double& value = component(image, row);
    value = high;
    if (high + (low - error) == high && high + (low + error) == high) {
      if (std::abs(low) > error) is_exact = false;
      if (!is_exact || (low == 0 && error == 0)) continue;
    }
    Dyadic exactly = exact(row, 3);
    for (int k = 0; k < 3; ++k) exactly += exact(row, k) * Dyadic(component(local, k));
    value = exactly.nearest();
    is_exact = is_exact && std::isfinite(value) && Dyadic(value) == exactly;
  }
  return is_exact;
}

}  // namespace sectile
