// Places without rounding: affine maps that are multiplied exactly, and where points come to be.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "sectile/transform.h"

namespace sectile {

class Frame;

/// An affine map with exact entries: what a Transform is before anything is rounded. Products are
/// exact, too, so that a translation may be the sum of several translations by doubles. A value:
/// cheap to copy, safe to read from many threads.
class ExactTransform {
 public:
  ExactTransform();  ///< leaves everything where it is
  /// Throws std::invalid_argument for a matrix that is not finite.
  ExactTransform(const Transform& transform);
  /// First `first`, then `second`.
  friend ExactTransform operator*(const ExactTransform& second, const ExactTransform& first);
  friend bool operator==(const ExactTransform& a, const ExactTransform& b);

  bool is_identity() const { return frame_ == nullptr; }
  Transform nearest() const;  ///< each entry rounded once
  /// The map back, if it can be said exactly: the matrix is one of doubles and its inverse, too, as
  /// for moves, turns by right angles and scales by powers of two.
  std::optional<ExactTransform> inverse() const;

  const Frame* frame() const { return frame_.get(); }  // internal; null: the identity

 private:
  explicit ExactTransform(std::shared_ptr<const Frame> frame) : frame_(std::move(frame)) {}
  std::shared_ptr<const Frame> frame_;
};

/// As transformed() by a Transform: the exact image. Throws std::invalid_argument for a matrix that
/// is singular.
Solid transformed(const Solid& solid, const ExactTransform& transform);

/// A point where a map takes it, times a factor.
struct WeightedImage {
  const ExactTransform& transform;
  Vec3 point;
  double factor = 1;
};

/// The sum of the images, each coordinate rounded once at the end: zero only if it is zero. So two
/// images are one point if the sum of the one and -1 times the other is zero.
Vec3 sum_of_images(std::span<const WeightedImage> images);

/// A corner of a solid: near + rest, which is exact for each coordinate that a sum of two doubles
/// can hold, and else comes within 2^-100 of it.
struct ExactCorner {
  Vec3 near;    ///< rounded to the nearest doubles
  Vec3 rest{};  ///< what is lost by that
  std::array<bool, 3> is_exact{true, true, true};
  friend bool operator==(const ExactCorner&, const ExactCorner&) = default;
};

/// Triangles of the faces of a solid, and for each of the positions the corner itself.
struct ExactMesh {
  PolygonMesh mesh;
  std::vector<ExactCorner> corners;
};

ExactMesh exact_mesh(const Solid& solid);

}  // namespace sectile
