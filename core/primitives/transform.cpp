#include "sectile/transform.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "primitives/arguments.h"
#include "primitives/checked_frame.h"
#include "primitives/circle.h"

namespace sectile {

namespace {

bool finite(const Vec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

Vec3 unit_axis(const Vec3& axis) {
  const double largest = std::max({std::fabs(axis.x), std::fabs(axis.y), std::fabs(axis.z)});
  require(finite(axis) && largest > 0, "The axis of a rotation must be finite and not zero.");
  // Through the power of two, so that nothing overflows and coordinate axes stay exact.
  const int exponent = std::ilogb(largest);
  const Vec3 scaled{std::scalbn(axis.x, -exponent), std::scalbn(axis.y, -exponent),
                    std::scalbn(axis.z, -exponent)};
  const double length = std::sqrt(scaled.x * scaled.x + scaled.y * scaled.y + scaled.z * scaled.z);
  return {scaled.x / length, scaled.y / length, scaled.z / length};
}

void reverse_faces(PolygonMesh& mesh) {
  std::size_t first = 0;
  for (const std::uint32_t size : mesh.face_sizes) {
    require(size <= mesh.indices.size() - first, "The mesh has fewer corners than its faces say.");
    std::reverse(mesh.indices.begin() + static_cast<std::ptrdiff_t>(first),
                 mesh.indices.begin() + static_cast<std::ptrdiff_t>(first + size));
    first += size;
  }
}

}  // namespace

void require_invertible(const Frame& frame) {
  require(frame.determinant().sign() != Sign::zero,
          "The matrix of the transform is singular: it would flatten the solid.");
}

Frame checked_frame(const Transform& transform) {
  for (const double m : transform.m)
    require(std::isfinite(m), "The matrix of a transform must be finite.");
  Frame frame(transform.m);
  require_invertible(frame);
  return frame;
}

Transform Transform::translation(const Vec3& by) {
  return {{1, 0, 0, by.x, 0, 1, 0, by.y, 0, 0, 1, by.z}};
}

Transform Transform::scaling(const Vec3& by) {
  return {{by.x, 0, 0, 0, 0, by.y, 0, 0, 0, 0, by.z, 0}};
}

// Rodrigues: cos·I + sin·[u]× + (1 - cos)·u·uᵀ, the diagonal written as u² + cos·(1 - u²). With u
// on a coordinate axis every product is with 0 or 1, so with cosine and sine exact the matrix is.
Transform Transform::rotation_degrees(const Vec3& axis, double degrees) {
  require(std::isfinite(degrees), "The angle of a rotation must be finite.");
  const Vec3 u = unit_axis(axis);
  const Vec2 turn = unit_vector(degrees);
  const double c = turn.x, s = turn.y, v = 1 - c;
  const double xx = u.x * u.x, yy = u.y * u.y, zz = u.z * u.z;
  return {{xx + c * (yy + zz), v * u.x * u.y - s * u.z, v * u.x * u.z + s * u.y, 0,
           v * u.x * u.y + s * u.z, yy + c * (zz + xx), v * u.y * u.z - s * u.x, 0,
           v * u.x * u.z - s * u.y, v * u.y * u.z + s * u.x, zz + c * (xx + yy), 0}};
}

Vec3 Transform::operator()(const Vec3& point) const {
  const double p[] = {point.x, point.y, point.z, 1};
  return {rounded_dot(&m[0], p), rounded_dot(&m[4], p), rounded_dot(&m[8], p)};
}

Transform operator*(const Transform& second, const Transform& first) {
  Transform product;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      const double entries[] = {first.m[column], first.m[4 + column], first.m[8 + column],
                                column == 3 ? 1.0 : 0.0};
      product.m[4 * row + column] = rounded_dot(&second.m[4 * row], entries);
    }
  }
  return product;
}

PolygonMesh transformed(const PolygonMesh& mesh, const Transform& transform) {
  const Frame frame = checked_frame(transform);
  PolygonMesh result = mesh;
  for (Vec3& position : result.positions) {
    const Vec3 image = transform(position);
    require(finite(image) || !finite(position),
            "The transformed mesh would be too large for double coordinates.");
    position = image;
  }
  if (frame.determinant().sign() == Sign::negative) reverse_faces(result);
  return result;
}

}  // namespace sectile
