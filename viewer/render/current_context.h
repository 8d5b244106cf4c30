// One context is current at a time, and the table of OpenGL functions belongs to it.
#pragma once

#include "render/graphics_context.h"

namespace sectile::viewer {

/// Throws std::runtime_error unless a picture of this size can be drawn.
void check_size(int width, int height);

/// What windows and memory contexts share: taking turns.
class TurnTakingContext : public GraphicsContext {
 public:
  void make_current() final;

 protected:
  using Function = void (*)();
  using Loader = Function (*)(const char* name);

  virtual void bind() = 0;    ///< makes the native context current; throws std::runtime_error
  virtual void unbind() = 0;  ///< leaves no native context current
  virtual Loader loader() const = 0;
  /// To be called in the destructor of each implementation, before the native context goes.
  void retire();
};

}  // namespace sectile::viewer
