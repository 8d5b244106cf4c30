// Turns what GLFW reports into plain events.
#pragma once

#include "events/input.h"
#include "render/graphics_context.h"

struct GLFWwindow;

namespace sectile::viewer {

/// From now on events of the window are appended to `input`, and `damaged` is set when
/// the window must be drawn again. All must outlive the window.
void collect_events(GLFWwindow* window, Input& input, bool& damaged,
                    const GraphicsContext& context);

}  // namespace sectile::viewer
