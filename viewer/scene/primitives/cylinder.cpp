#include "scene/primitives/parameters.h"

namespace sectile::viewer {
namespace {

constexpr PrimitiveField fields[] = {radius_field, height_field, segments_field};

Solid solid(const Primitive& p) {
  require_faces(std::uint64_t{p.segments} * 2);
  require_length(p.height, "height");
  return centred(cylinder(p.radius, p.height, p.segments), p.height);
}

}  // namespace

extern const PrimitiveKind cylinder_kind{"cylinder", fields, solid};

}  // namespace sectile::viewer
