// Collects the polygons of a primitive.
#pragma once

#include <initializer_list>
#include <span>

#include "import/soup.h"

namespace sectile {

class SoupBuilder {
 public:
  std::uint32_t add_position(const Vec3& position);
  const Vec3& position(std::uint32_t index) const { return soup_.positions[index]; }

  void add_face(std::span<const std::uint32_t> corners);
  void add_face(std::initializer_list<std::uint32_t> corners);
  /// The outer loop first.
  void add_face(std::span<const std::vector<std::uint32_t>> loops);

  Solid solid() const { return Solid(import_soup(soup_)); }

 private:
  void add_loop(std::span<const std::uint32_t> corners);

  Soup soup_;
};

/// Do four points lie on one plane, exactly?
bool coplanar(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

}  // namespace sectile
