// Moving a solid: exact, and postponed until someone asks for its points.
#include "primitives/checked_frame.h"
#include "sectile/transform.h"
#include "storage/moved_solid.h"

namespace sectile {

Solid transformed(const Solid& solid, const Transform& transform) {
  const Frame frame = checked_frame(transform);
  if (solid.is_empty()) return solid;
  const MovedSolid* before = solid.moved();
  const auto& original = before ? before->original() : solid.data();
  const Frame all = before ? frame * before->frame() : frame;
  if (all.is_identity()) return Solid(original);
  return Solid(std::make_shared<const MovedSolid>(original, all));
}

}  // namespace sectile
