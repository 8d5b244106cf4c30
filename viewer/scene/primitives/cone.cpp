#include "scene/primitives/parameters.h"

namespace sectile::viewer {
namespace {

constexpr PrimitiveField fields[] = {radius_field,
                                     {"Top radius", "top_radius", &Primitive::top_radius, 0, 1e6},
                                     height_field,
                                     segments_field};

Solid solid(const Primitive& p) {
  require_faces(std::uint64_t{p.segments} * 2);
  require_length(p.height, "height");
  return centred(cone(p.radius, p.top_radius, p.height, p.segments), p.height);
}

}  // namespace

extern const PrimitiveKind cone_kind{"cone", fields, solid};

}  // namespace sectile::viewer
