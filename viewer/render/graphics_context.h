// An OpenGL 3.3 core context: a window (GLFW) or memory (OSMesa or EGL). Three small
// implementations; which one is chosen at run time. No OpenGL call is made outside this folder.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace sectile::viewer {

/// Rows from top to bottom, four bytes RGBA for each pixel.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

class GraphicsContext {
 public:
  virtual ~GraphicsContext() = default;
  /// Makes the context current and (re)loads the OpenGL functions for it if another one was.
  virtual void make_current() = 0;
  virtual int width() const = 0;  ///< of the frame buffer, in pixels
  virtual int height() const = 0;
  virtual float scale() const = 0;  ///< pixels for each unit of the user interface (200 % is 2)
  virtual void present() = 0;       ///< shows the frame (nothing to do off-screen)
};

/// Draws into memory: by OSMesa, or by EGL where Mesa has no OSMesa any more (since 25.1). Both are
/// opened at run time. Throws std::runtime_error with a message that says what to install.
std::unique_ptr<GraphicsContext> make_offscreen_context(int width, int height, float scale = 1);

bool has_osmesa();  ///< is its library installed?
std::unique_ptr<GraphicsContext> make_osmesa_context(int width, int height, float scale = 1);
std::unique_ptr<GraphicsContext> make_egl_context(int width, int height, float scale = 1);

}  // namespace sectile::viewer
