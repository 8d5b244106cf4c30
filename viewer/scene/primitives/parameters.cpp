#include "scene/primitives/parameters.h"

#include <cmath>
#include <stdexcept>

namespace sectile::viewer {

void require_length(double length, const char* what) {
  if (!(length > 0) || !std::isfinite(length))
    throw std::invalid_argument(std::string("The ") + what + " must be a positive number.");
}

// A slip in a typed number must not fill the memory.
void require_faces(std::uint64_t count) {
  if (count > 4'000'000)
    throw std::invalid_argument("That would be " + std::to_string(count) +
                                " faces; choose fewer segments.");
}

Vec3 high_corner(const Primitive& primitive) {
  require_length(primitive.size.x, "size along x");
  require_length(primitive.size.y, "size along y");
  require_length(primitive.size.z, "size along z");
  return {primitive.size.x / 2, primitive.size.y / 2, primitive.size.z / 2};
}

void check_sides_and_height(const Primitive& primitive) {
  require_faces(std::uint64_t{primitive.segments} * 2);
  require_length(primitive.height, "height");
}

void begin_with_six_sides(Primitive& primitive) {
  primitive.segments = 6;
}

Solid centred(const Solid& standing, double height) {
  return transformed(standing, Transform::translation({0, 0, -height / 2}));
}

}  // namespace sectile::viewer
