// Lines around the silhouettes of surfaces: thick around what is selected, thin around operands.
// They cost as much as the pixels they surround, however dense the surfaces are.
#pragma once

#include "render/surfaces.h"

namespace sectile::viewer {

class OutlineDrawer {
 public:
  explicit OutlineDrawer(SurfaceDrawer& surfaces);
  void draw(const View& view, Targets& targets);

 private:
  struct Around;
  void draw_around(const View& view, Targets& targets, const Around& around);

  SurfaceDrawer& surfaces_;
  ShaderProgram outline_;
  GlVertexArray nothing_;
};

}  // namespace sectile::viewer
