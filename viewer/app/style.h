// Colours and distances of the user interface, light and dark.
#pragma once

#include <imgui.h>

#include "picture/picture.h"

namespace sectile::viewer {

void apply_style(bool dark);

ImU32 packed(const Colour& colour);
ImVec4 vector(const Colour& colour);

}  // namespace sectile::viewer
