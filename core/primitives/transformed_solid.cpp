// Moving a solid: exact, and postponed until someone asks for its points.
#include "sectile/exact_transform.h"

namespace sectile {

Solid transformed(const Solid& solid, const Transform& transform) {
  return transformed(solid, ExactTransform(transform));
}

}  // namespace sectile
