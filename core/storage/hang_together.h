// Do all faces of a solid hang together over edges?
#pragma once

#include "storage/solid_data.h"

namespace sectile {

bool hang_together(const SolidData& solid);

}  // namespace sectile
