#include "scene/primitives/parameters.h"

namespace sectile::viewer {
namespace {

constexpr PrimitiveField fields[] = {radius_field, segments_field, rings_field};

Solid solid(const Primitive& p) {
  require_faces(2 * std::uint64_t{p.segments} * p.rings);
  return sphere(p.radius, p.segments, p.rings);
}

}  // namespace

extern const PrimitiveKind sphere_kind{"sphere", fields, solid};

}  // namespace sectile::viewer
