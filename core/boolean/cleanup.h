// Phase 8: edges between parts of one and the same face, and vertices in the middle of straight
// edges that nothing needs any more, disappear.
#pragma once

#include "boolean/gluing.h"

namespace sectile {

void clean_up(Glued& glued);

}  // namespace sectile
