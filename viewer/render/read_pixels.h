// Pictures out of frame buffers.
#pragma once

#include "render/gl_objects.h"
#include "render/graphics_context.h"

namespace sectile::viewer {

/// The colours of a frame buffer (0: that of the context), opaque.
Image read_pixels(GLuint framebuffer, int width, int height);

}  // namespace sectile::viewer
