#include "app/placing.h"

namespace sectile::viewer {

Bounds moved(const Bounds& bounds, const glm::dmat4& by) {
  Bounds result;
  if (bounds.is_empty()) return result;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec4 p(corner & 1 ? bounds.high.x : bounds.low.x,
                       corner & 2 ? bounds.high.y : bounds.low.y,
                       corner & 4 ? bounds.high.z : bounds.low.z, 1);
    result.add(glm::dvec3(by * p));
  }
  return result;
}

}  // namespace sectile::viewer
