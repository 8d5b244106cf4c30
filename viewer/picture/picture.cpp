#include "picture/picture.h"

namespace sectile::viewer {
namespace {

// Of a box that is moved: the box around its corners.
Bounds moved(const Bounds& box, const glm::dmat4& model) {
  Bounds result;
  if (box.is_empty()) return result;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p(corner & 1 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y,
                       corner & 4 ? box.high.z : box.low.z);
    result.add(glm::dvec3(model * glm::dvec4(p, 1)));
  }
  return result;
}

}  // namespace

Bounds Picture::bounds() const {
  Bounds all;
  for (const Surface& surface : surfaces)
    if (surface.mesh) all.add(moved(surface.mesh->bounds, surface.model));
  for (const Lines& some : lines)
    for (const glm::vec3& end : some.ends) all.add(glm::dvec3(end));
  for (const Points& some : points)
    for (const glm::vec3& place : some.places) all.add(glm::dvec3(place));
  return all;
}

}  // namespace sectile::viewer
