// Which node a click in the picture means.
#pragma once

#include "app/session.h"
#include "scene/picking.h"

namespace sectile::viewer {

/// outer: the operation or group that what is hit belongs to; inner: one level deeper than what is
/// selected now.
enum class Depth { outer, inner };

/// 0 if the ray hits nothing.
NodeId clicked_node(const Session& session, Picker& picker, const Ray& ray, Depth depth);

}  // namespace sectile::viewer
