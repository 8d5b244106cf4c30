#include "render/current_context.h"

#include <glad/gl.h>

#include <stdexcept>
#include <string>

namespace sectile::viewer {
namespace {

TurnTakingContext* current = nullptr;

}  // namespace

void check_size(int width, int height) {
  if (width <= 0 || height <= 0 || width > 16384 || height > 16384)
    throw std::runtime_error("A picture can be 1 to 16384 pixels wide and high");
}

std::unique_ptr<GraphicsContext> make_offscreen_context(int width, int height, float scale) {
  return has_osmesa() ? make_osmesa_context(width, height, scale)
                      : make_egl_context(width, height, scale);
}

void TurnTakingContext::make_current() {
  if (current == this) return;
  if (current) current->unbind();
  current = nullptr;
  bind();
  const int version = gladLoadGL(loader());
  if (version < GLAD_MAKE_VERSION(3, 3)) {
    unbind();
    throw std::runtime_error("OpenGL 3.3 is needed, but this machine has " +
                             std::to_string(GLAD_VERSION_MAJOR(version)) + "." +
                             std::to_string(GLAD_VERSION_MINOR(version)));
  }
  current = this;
}

void TurnTakingContext::retire() {
  if (current != this) return;
  unbind();
  current = nullptr;
}

}  // namespace sectile::viewer
