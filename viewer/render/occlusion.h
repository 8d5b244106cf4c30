// Darkens corners and hollows of the opaque surfaces, from the depth of the picture alone.
#pragma once

#include "render/shader_program.h"
#include "render/targets.h"
#include "render/view.h"

namespace sectile::viewer {

class Occlusion {
 public:
  Occlusion();
  /// `projection`: the camera's; `radius`: how far in the world things darken each other.
  void darken(const View& view, const glm::dmat4& projection, double radius, Targets& targets);

 private:
  struct Half {
    GlTexture texture;
    GlFramebuffer framebuffer;
  };
  void resize(int width, int height);

  ShaderProgram find_, blur_, apply_;
  GlVertexArray nothing_;
  Half found_, blurred_;
  int width_ = 0, height_ = 0;
};

}  // namespace sectile::viewer
