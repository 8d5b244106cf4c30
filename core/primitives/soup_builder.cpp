#include "primitives/soup_builder.h"

#include "numbers/dyadic.h"

namespace sectile {

std::uint32_t SoupBuilder::add_position(const Vec3& position) {
  soup_.positions.push_back(position);
  return static_cast<std::uint32_t>(soup_.positions.size() - 1);
}

void SoupBuilder::add_loop(std::span<const std::uint32_t> corners) {
  soup_.loop_sizes.push_back(static_cast<std::uint32_t>(corners.size()));
  soup_.indices.insert(soup_.indices.end(), corners.begin(), corners.end());
}

void SoupBuilder::add_face(std::span<const std::uint32_t> corners) {
  soup_.face_loops.push_back(1);
  add_loop(corners);
}

void SoupBuilder::add_face(std::initializer_list<std::uint32_t> corners) {
  add_face(std::span<const std::uint32_t>(corners.begin(), corners.size()));
}

void SoupBuilder::add_face(std::span<const std::vector<std::uint32_t>> loops) {
  soup_.face_loops.push_back(static_cast<std::uint32_t>(loops.size()));
  for (const std::vector<std::uint32_t>& loop : loops) add_loop(loop);
}

namespace {

struct ExactVector {
  Dyadic x, y, z;
};

ExactVector difference(const Vec3& a, const Vec3& b) {
  return {Dyadic(a.x) - Dyadic(b.x), Dyadic(a.y) - Dyadic(b.y), Dyadic(a.z) - Dyadic(b.z)};
}

Dyadic determinant(const ExactVector& a, const ExactVector& b, const ExactVector& c) {
  return a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
         a.z * (b.x * c.y - b.y * c.x);
}

}  // namespace

bool coplanar(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return determinant(difference(b, a), difference(c, a), difference(d, a)).sign() == Sign::zero;
}

}  // namespace sectile
