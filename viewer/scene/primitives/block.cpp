#include "scene/primitives/parameters.h"

namespace sectile::viewer {
namespace {

constexpr PrimitiveField fields[] = {size_field};

Solid solid(const Primitive& p) {
  require_length(p.size.x, "size along x");
  require_length(p.size.y, "size along y");
  require_length(p.size.z, "size along z");
  const Vec3 high{p.size.x / 2, p.size.y / 2, p.size.z / 2};
  return block({-high.x, -high.y, -high.z}, high);
}

}  // namespace

extern const PrimitiveKind block_kind{"block", fields, solid};

}  // namespace sectile::viewer
