// Affine maps with exact entries: where moved points have their coordinates in doubles.
#pragma once

#include <array>

#include "numbers/bounded.h"
#include "numbers/dyadic.h"
#include "sectile/mesh.h"

namespace sectile {

/// a[0]·b[0] + … + a[3]·b[3], rounded to the nearest double; plain floating point if a factor is
/// not finite.
double rounded_dot(const double a[4], const double b[4]);

/// An exact number, and what pairs of doubles know of it.
class ExactNumber {
 public:
  ExactNumber() = default;
  explicit ExactNumber(Dyadic value);
  const Dyadic& exact() const { return exact_; }
  const Bounded& near() const { return near_; }
  template <class Number>
  const Number& as() const;

 private:
  Dyadic exact_;
  Bounded near_;
};

template <>
inline const Dyadic& ExactNumber::as<Dyadic>() const {
  return exact_;
}
template <>
inline const Bounded& ExactNumber::as<Bounded>() const {
  return near_;
}

/// x' = m[0]·x + m[1]·y + m[2]·z + m[3], and so on, row by row.
class Frame {
 public:
  /// All entries are finite.
  explicit Frame(const std::array<double, 12>& m);
  explicit Frame(const std::array<Dyadic, 12>& m);
  /// First `first`, then `second`, multiplied exactly.
  friend Frame operator*(const Frame& second, const Frame& first);

  const ExactNumber& entry(int row, int column) const {
    return entries_[static_cast<std::size_t>(4 * row + column)];
  }
  const Dyadic& exact(int row, int column) const { return entry(row, column).exact(); }
  /// Entries of the linear part's matrix of cofactors: normals are mapped by it.
  Dyadic cofactor(int row, int column) const;
  Dyadic determinant() const;
  bool is_identity() const;

  template <class Number>
  void map(const Vec3& local, Number (&image)[3]) const {
    const Number x(local.x), y(local.y), z(local.z);
    for (int row = 0; row < 3; ++row)
      image[row] = entry(row, 0).as<Number>() * x + entry(row, 1).as<Number>() * y +
                   entry(row, 2).as<Number>() * z + entry(row, 3).as<Number>();
  }
  /// The image, rounded to nearest. True if that is exact.
  bool round(const Vec3& local, Vec3& image) const;

 private:
  Frame() = default;
  void find_doubles();

  std::array<ExactNumber, 12> entries_;
  std::array<double, 12> doubles_{};
  bool all_doubles_ = false;
};

}  // namespace sectile
