#include "scene/primitives.h"

#include <cmath>
#include <stdexcept>

namespace sectile::viewer {

namespace {

void require_length(double length, const char* what) {
  if (!(length > 0) || !std::isfinite(length))
    throw std::invalid_argument(std::string("The ") + what + " must be a positive number.");
}

void require_size(const Vec3& size) {
  require_length(size.x, "size along x");
  require_length(size.y, "size along y");
  require_length(size.z, "size along z");
}

// A slip in a typed number must not fill the memory.
void require_count(std::uint64_t count) {
  if (count > 4'000'000)
    throw std::invalid_argument("That would be " + std::to_string(count) +
                                " faces; choose fewer segments.");
}

// What the library makes standing on z = 0.
Solid centred(const Solid& standing, double height) {
  return transformed(standing, Transform::translation({0, 0, -height / 2}));
}

Solid from_size(const Primitive& p) {
  require_size(p.size);
  const Vec3 high{p.size.x / 2, p.size.y / 2, p.size.z / 2};
  const Vec3 low{-high.x, -high.y, -high.z};
  return p.shape == Primitive::Shape::block ? block(low, high) : wedge(low, high);
}

Solid standing(const Primitive& p) {
  switch (p.shape) {
    case Primitive::Shape::prism:
      return prism(p.radius, p.height, p.segments);
    case Primitive::Shape::pyramid:
      return pyramid(p.radius, p.height, p.segments);
    case Primitive::Shape::cylinder:
      return cylinder(p.radius, p.height, p.segments);
    case Primitive::Shape::cone:
      return cone(p.radius, p.top_radius, p.height, p.segments);
    default:
      return extrude(p.profile, p.height);
  }
}

}  // namespace

Solid solid_of(const Primitive& p) {
  require_count(std::uint64_t{p.segments} * 2);
  switch (p.shape) {
    case Primitive::Shape::block:
    case Primitive::Shape::wedge:
      return from_size(p);
    case Primitive::Shape::sphere:
      require_count(2 * std::uint64_t{p.segments} * p.rings);
      return sphere(p.radius, p.segments, p.rings);
    case Primitive::Shape::torus:
      require_count(2 * std::uint64_t{p.segments} * p.rings);
      return torus(p.radius, p.minor_radius, p.segments, p.rings);
    case Primitive::Shape::revolution:
      require_count(2 * std::uint64_t{p.segments} * p.profile.outer.size());
      return revolve(p.profile, p.segments);
    default:
      require_length(p.height, "height");
      return centred(standing(p), p.height);
  }
}

}  // namespace sectile::viewer
