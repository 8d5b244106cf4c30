// The modeller in a window or into a picture.
#pragma once

#include "program/arguments.h"
#include "render/graphics_context.h"

namespace sectile::viewer {

class Window;

/// Until the window is closed.
void run_in_window(const Arguments& arguments, Window& window);
/// What the window would show, drawn off-screen.
Image modeller_screenshot(const Arguments& arguments);

}  // namespace sectile::viewer
