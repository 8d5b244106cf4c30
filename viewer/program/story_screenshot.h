// A picture of one step of an operation, or of its operands, without the modeller.
#pragma once

#include "program/arguments.h"
#include "render/graphics_context.h"

namespace sectile::viewer {

/// Throws std::runtime_error (also the errors of files and solids), and std::invalid_argument if
/// there is no such step.
Image story_screenshot(const Arguments& arguments);

}  // namespace sectile::viewer
