// Arcs of a spherical picture as points, and which directions lie inside a solid. For the eye only.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "story/story.h"

namespace sectile::viewer {

/// Points along an arc, ends included; a full circle closes.
std::vector<glm::vec3> points_of(const SpherePicture::Arc& arc);

/// Is a direction inside the neighborhood of a solid? Decided by the nearest arc: its face's normal
/// points outwards.
bool is_inside(const SpherePicture& picture, int solid, const glm::vec3& direction);

}  // namespace sectile::viewer
