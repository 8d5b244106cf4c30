#include "scene/primitives/parameters.h"

namespace sectile::viewer {
namespace {

constexpr PrimitiveField fields[] = {radius_field, height_field, sides_field};

Solid solid(const Primitive& p) {
  check_sides_and_height(p);
  return centred(prism(p.radius, p.height, p.segments), p.height);
}

}  // namespace

extern const PrimitiveKind prism_kind{"prism", fields, solid, ProfileUse::none,
                                      begin_with_six_sides};

}  // namespace sectile::viewer
