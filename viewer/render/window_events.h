// Turns what GLFW reports into plain events.
#pragma once

#include "app/input.h"
#include "render/graphics_context.h"

struct GLFWwindow;

namespace sectile::viewer {

/// From now on events of the window are appended to `input`. All three must outlive the window.
void collect_events(GLFWwindow* window, Input& input, const GraphicsContext& context);

}  // namespace sectile::viewer
