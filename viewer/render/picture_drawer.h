// Draws one picture into a rectangle of the frame.
#pragma once

#include <memory>
#include <optional>

#include "render/ground.h"
#include "render/marks.h"
#include "render/occlusion.h"
#include "render/outlines.h"
#include "render/shadow.h"

namespace sectile::viewer {

class PictureDrawer {
 public:
  void draw(const Picture& picture, const Viewport& viewport, int frame_height, float scale);
  /// A picture of any size, by itself.
  Image draw_image(const Picture& picture, int width, int height, float scale);
  const DrawnWork& work() const { return work_; }

 private:
  // What was drawn last in one quality.
  struct Kept {
    std::unique_ptr<Targets> targets;
    std::optional<Picture> drawn;
    float scale = 1;
  };
  Kept& kept(const Viewport& viewport, Quality quality);
  void paint(const Picture& picture, const Viewport& viewport, float scale, Targets& targets);

  MeshCache meshes_;
  SurfaceDrawer surfaces_{meshes_};
  MarkDrawer marks_{meshes_};
  GroundDrawer ground_;
  Occlusion occlusion_;
  Shadow shadow_{surfaces_};
  OutlineDrawer outlines_{surfaces_};
  Kept fast_, full_;
  DrawnWork work_;
};

}  // namespace sectile::viewer
