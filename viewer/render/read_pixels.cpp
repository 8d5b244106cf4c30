#include "render/read_pixels.h"

#include <algorithm>

namespace sectile::viewer {

Image read_pixels(GLuint framebuffer, int width, int height) {
  Image image{width, height, {}};
  const std::size_t row = static_cast<std::size_t>(image.width) * 4;
  image.rgba.resize(row * static_cast<std::size_t>(image.height));
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  // OpenGL's rows go upwards.
  for (int y = 0; y < image.height / 2; ++y) {
    const auto upper = image.rgba.begin() + static_cast<std::ptrdiff_t>(row) * y;
    const auto lower =
        image.rgba.begin() + static_cast<std::ptrdiff_t>(row) * (image.height - 1 - y);
    std::swap_ranges(upper, upper + static_cast<std::ptrdiff_t>(row), lower);
  }
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 255;
  return image;
}

}  // namespace sectile::viewer
