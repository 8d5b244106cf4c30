// The modeller in a window or into a picture.
#pragma once

#include <functional>

#include "program/arguments.h"
#include "render/graphics_context.h"

namespace sectile::viewer {

class App;
class Window;

/// Until the window is closed.
void run_in_window(const Arguments& arguments, Window& window);
/// A modeller without a window that shows what the arguments say, and has come to rest.
void with_still_modeller(const Arguments& arguments, const std::function<void(App&)>& use);
/// What the window would show, drawn off-screen.
Image modeller_screenshot(const Arguments& arguments);

}  // namespace sectile::viewer
