// The soft shadow of the opaque surfaces on the ground.
#pragma once

#include <optional>
#include <vector>

#include "render/surfaces.h"

namespace sectile::viewer {

class Shadow {
 public:
  explicit Shadow(SurfaceDrawer& surfaces);

  /// Where it may fall, for the range of depths; empty if nothing casts one.
  static Bounds place_of(const Picture& picture);
  /// Finds what the surfaces hide, unless they are those of the last time. Leaves another frame
  /// buffer bound.
  void find(const View& view);
  /// Under the surfaces, with their depth. Nothing, if it was found for other surfaces.
  void draw(const View& view);

 private:
  struct Caster {
    std::shared_ptr<const SurfaceMesh> mesh;
    glm::dmat4 model;
    bool operator==(const Caster&) const = default;
  };
  struct Found {
    std::vector<Caster> casters;
    SectionPlane section;
    bool operator==(const Found&) const = default;
  };
  static Found wanted(const Picture& picture);

  SurfaceDrawer& surfaces_;
  ShaderProgram blur_, draw_;
  GlVertexArray nothing_;
  GlTexture heights_, shadow_;
  GlFramebuffer below_, blurred_;
  std::optional<Found> found_;
  Bounds place_;
};

}  // namespace sectile::viewer
