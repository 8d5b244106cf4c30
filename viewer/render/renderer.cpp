#include "render/renderer.h"

#include "render/interface_drawer.h"
#include "render/picture_drawer.h"
#include "render/read_pixels.h"

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

Image Renderer::draw_image(const Picture& picture, int width, int height, float scale) {
  implementation_->context.make_current();
  return implementation_->pictures.draw_image(picture, width, height, scale);
}

const DrawnWork& Renderer::work() const {
  return implementation_->pictures.work();
}

Image Renderer::read_frame() {
  GraphicsContext& context = implementation_->context;
  context.make_current();
  return read_pixels(0, context.width(), context.height());
}

}  // namespace sectile::viewer
