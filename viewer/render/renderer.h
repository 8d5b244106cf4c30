// Draws pictures and the user interface with OpenGL into the current frame buffer.
#pragma once

#include <cstdint>
#include <memory>

#include "picture/picture.h"
#include "render/graphics_context.h"

struct ImDrawData;

namespace sectile::viewer {

/// The rectangle of the frame buffer that a picture fills, in pixels from the top left.
struct Viewport {
  int x = 0, y = 0, width = 0, height = 0;
};

/// What was painted since the renderer was made. Frames in which the picture stays as it is add
/// nothing.
struct DrawnWork {
  std::uint64_t pictures = 0, samples = 0, triangles = 0;
};

class Renderer {
 public:
  /// The context must outlive the renderer.
  explicit Renderer(GraphicsContext& context);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  void begin_frame();  ///< makes the context current, clears
  void draw(const Picture& picture, const Viewport& viewport);
  void draw(const ImDrawData& interface);  ///< the font texture included
  /// A picture of any size by itself, whatever the frame buffer's.
  Image draw_image(const Picture& picture, int width, int height, float scale = 1);
  const DrawnWork& work() const;
  Image read_frame();  ///< what was drawn since begin_frame

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// The bytes of a PNG without transparency.
std::string png_of(const Image& image);
/// Writes a PNG whole or not at all; throws std::runtime_error.
void write_png(const std::string& path, const Image& image);
Image read_png(const std::string& path);

}  // namespace sectile::viewer
