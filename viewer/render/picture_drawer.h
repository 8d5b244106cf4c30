// Draws one picture into a rectangle of the frame.
#pragma once

#include <memory>

#include "render/ground.h"
#include "render/marks.h"
#include "render/surfaces.h"

namespace sectile::viewer {

class PictureDrawer {
 public:
  void draw(const Picture& picture, const Viewport& viewport, int frame_height, float scale);

 private:
  Targets& targets(const Viewport& viewport, Quality quality);

  MeshCache meshes_;
  SurfaceDrawer surfaces_{meshes_};
  MarkDrawer marks_{meshes_};
  GroundDrawer ground_;
  std::unique_ptr<Targets> fast_, full_;
};

}  // namespace sectile::viewer
