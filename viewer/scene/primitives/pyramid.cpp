#include "scene/primitives/parameters.h"

namespace sectile::viewer {
namespace {

constexpr PrimitiveField fields[] = {radius_field, height_field, sides_field};

Solid solid(const Primitive& p) {
  require_faces(std::uint64_t{p.segments} * 2);
  require_length(p.height, "height");
  return centred(pyramid(p.radius, p.height, p.segments), p.height);
}

void begin(Primitive& p) {
  p.segments = 6;
}

}  // namespace

extern const PrimitiveKind pyramid_kind{"pyramid", fields, solid, ProfileUse::none, begin};

}  // namespace sectile::viewer
