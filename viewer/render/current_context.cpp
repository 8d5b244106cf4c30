#include "render/current_context.h"

#include <glad/gl.h>

#include <stdexcept>
#include <string>

namespace sectile::viewer {
namespace {

TurnTakingContext* current = nullptr;

}  // namespace

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
