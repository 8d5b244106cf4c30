#include "scene/primitives/parameters.h"

namespace sectile::viewer {
namespace {

constexpr PrimitiveField fields[] = {radius_field,
                                     {"Minor radius", "minor_radius", &Primitive::minor_radius},
                                     segments_field,
                                     rings_field};

Solid solid(const Primitive& p) {
  require_faces(2 * std::uint64_t{p.segments} * p.rings);
  return torus(p.radius, p.minor_radius, p.segments, p.rings);
}

}  // namespace

extern const PrimitiveKind torus_kind{"torus", fields, solid};

}  // namespace sectile::viewer
