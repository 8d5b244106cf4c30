#include "render/renderer.h"

#include <algorithm>

#include "render/interface_drawer.h"
#include "render/picture_drawer.h"

namespace sectile::viewer {

class Renderer::Implementation {
 public:
  explicit Implementation(GraphicsContext& owner) : context(owner) {}

  GraphicsContext& context;
  PictureDrawer pictures;
  InterfaceDrawer interfaces;
};

Renderer::Renderer(GraphicsContext& context) {
  context.make_current();
  implementation_ = std::make_unique<Implementation>(context);
}

Renderer::~Renderer() {
  implementation_->context.make_current();
}

void Renderer::begin_frame() {
  GraphicsContext& context = implementation_->context;
  context.make_current();
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glDisable(GL_SCISSOR_TEST);
  glViewport(0, 0, context.width(), context.height());
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
}

void Renderer::draw(const Picture& picture, const Viewport& viewport) {
  const GraphicsContext& context = implementation_->context;
  implementation_->pictures.draw(picture, viewport, context.height(), context.scale());
}

void Renderer::draw(const ImDrawData& interface) {
  const GraphicsContext& context = implementation_->context;
  implementation_->interfaces.draw(interface, context.width(), context.height());
}

Image Renderer::read_frame() {
  GraphicsContext& context = implementation_->context;
  context.make_current();
  Image image{context.width(), context.height(), {}};
  const std::size_t row = static_cast<std::size_t>(image.width) * 4;
  image.rgba.resize(row * static_cast<std::size_t>(image.height));
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
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
