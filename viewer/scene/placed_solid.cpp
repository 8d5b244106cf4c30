#include "scene/placed_solid.h"

#include "scene/transforms.h"
#include "sectile/rounded_move.h"

namespace sectile::viewer {

Solid placed_solid(const Solid& solid, const Transform& by) {
  const Vec3 move{by.m[3], by.m[7], by.m[11]};
  if (by.m == Transform::translation(move).m)
    if (std::optional<Solid> image = rounded_move(solid, move)) return *std::move(image);
  return transformed(solid, by);
}

}  // namespace sectile::viewer
