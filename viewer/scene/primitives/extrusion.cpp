#include "scene/primitives/parameters.h"

namespace sectile::viewer {
namespace {

constexpr PrimitiveField fields[] = {height_field};

Solid solid(const Primitive& p) {
  require_length(p.height, "height");
  return centred(extrude(p.profile, p.height), p.height);
}

void begin(Primitive& p) {
  p.height = 1;
  // An L to start from.
  p.profile.outer = {{-1, -1}, {1, -1}, {1, 0}, {0, 0}, {0, 1}, {-1, 1}};
}

}  // namespace

extern const PrimitiveKind extrusion_kind{"extrusion", fields, solid, ProfileUse::extruded, begin};

}  // namespace sectile::viewer
