#include "degenerate.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sectile::cli {
namespace {

struct Point2 {
  double x, y;
};

// Keeps a sum of doubles exactly, as doubles that do not overlap.
class ExactSum {
 public:
  void add_product(double a, double b) {
    const double product = a * b;
    add(std::fma(a, b, -product));
    add(product);
  }
  bool is_zero() const { return size_ == 0; }

 private:
  void add(double term) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const double sum = term + parts_[i];
      const double part = sum - term;
      const double rest = (term - (sum - part)) + (parts_[i] - part);
      if (rest != 0) parts_[kept++] = rest;
      term = sum;
    }
    if (term != 0) parts_[kept++] = term;
    size_ = kept;
  }

  std::array<double, 12> parts_{};
  std::size_t size_ = 0;
};

int exponent_of(double a, double b, double c) {
  const double most = std::max({std::abs(a), std::abs(b), std::abs(c)});
  return most == 0 ? 0 : std::ilogb(most);
}

// Collinearity does not change when an axis is scaled; this keeps products within range.
bool exactly_collinear(Point2 a, Point2 b, Point2 c) {
  const int x = 400 - exponent_of(a.x, b.x, c.x);
  const int y = 400 - exponent_of(a.y, b.y, c.y);
  for (Point2* p : {&a, &b, &c}) *p = {std::ldexp(p->x, x), std::ldexp(p->y, y)};
  ExactSum area;
  area.add_product(a.x, b.y);
  area.add_product(-a.x, c.y);
  area.add_product(b.x, c.y);
  area.add_product(-b.x, a.y);
  area.add_product(c.x, a.y);
  area.add_product(-c.x, b.y);
  return area.is_zero();
}

bool collinear(const Point2& a, const Point2& b, const Point2& c) {
  const double left = (b.x - a.x) * (c.y - a.y), right = (b.y - a.y) * (c.x - a.x);
  const double size = std::abs(left) + std::abs(right);
  // Far above all rounding errors and far from underflow.
  if (size > 1e-280 && size < 1e280 && std::abs(left - right) > 1e-14 * size) return false;
  return exactly_collinear(a, b, c);
}

bool is_degenerate(const Vec3& a, const Vec3& b, const Vec3& c) {
  return collinear({a.x, a.y}, {b.x, b.y}, {c.x, c.y}) &&
         collinear({a.y, a.z}, {b.y, b.z}, {c.y, c.z}) &&
         collinear({a.z, a.x}, {b.z, b.x}, {c.z, c.x});
}

// GCC 12 drops a plain conversion to float and back when it vectorizes.
double to_float(double value) {
  const volatile float rounded = static_cast<float>(value);
  return rounded;
}

Vec3 to_floats(const Vec3& p) {
  return {to_float(p.x), to_float(p.y), to_float(p.z)};
}

}  // namespace

std::size_t count_degenerate_triangles(const PolygonMesh& triangles, FileFormat format) {
  std::size_t count = 0;
  const bool floats = format == FileFormat::stl_binary || format == FileFormat::three_mf;
  const auto position = [&](std::size_t corner) {
    const Vec3& p = triangles.positions[triangles.indices[corner]];
    return floats ? to_floats(p) : p;
  };
  for (std::size_t i = 0; i + 2 < triangles.indices.size(); i += 3)
    count += is_degenerate(position(i), position(i + 1), position(i + 2));
  return count;
}

}  // namespace sectile::cli
