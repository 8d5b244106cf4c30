#include "scene/primitives/parameters.h"

namespace sectile::viewer {
namespace {

constexpr PrimitiveField fields[] = {size_field};

Solid solid(const Primitive& p) {
  const Vec3 high = high_corner(p);
  return wedge({-high.x, -high.y, -high.z}, high);
}

}  // namespace

extern const PrimitiveKind wedge_kind{"wedge", fields, solid};

}  // namespace sectile::viewer
