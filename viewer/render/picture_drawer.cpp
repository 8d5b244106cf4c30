#include "render/picture_drawer.h"

#include <algorithm>

namespace sectile::viewer {
namespace {

constexpr int samples_at_rest = 4;

// A headlight, somewhat from the left and from above.
glm::dvec3 key_light(const Camera& camera) {
  return glm::normalize(-camera.forward() + 0.45 * camera.up() - 0.35 * camera.right());
}

bool has(const Picture& picture, bool Surface::*what) {
  return std::any_of(picture.surfaces.begin(), picture.surfaces.end(),
                     [&](const Surface& surface) { return surface.mesh && surface.*what; });
}

void set_initial_state() {
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_MULTISAMPLE);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glActiveTexture(GL_TEXTURE0);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
}

}  // namespace

Targets& PictureDrawer::targets(const Viewport& viewport, Quality quality) {
  auto& kept = quality == Quality::fast ? fast_ : full_;
  if (!kept || kept->width() != viewport.width || kept->height() != viewport.height) {
    kept.reset();
    kept = std::make_unique<Targets>(viewport.width, viewport.height,
                                     quality == Quality::fast ? 1 : samples_at_rest);
  }
  return *kept;
}

void PictureDrawer::draw(const Picture& picture, const Viewport& viewport, int frame_height,
                         float scale) {
  if (viewport.width <= 0 || viewport.height <= 0) return;
  const glm::dvec2 size(viewport.width, viewport.height);
  const Ground ground = Ground::of(picture, size);
  Bounds depth_range = picture.bounds();
  if (picture.surroundings.show_grid || picture.surroundings.show_axes)
    depth_range.add(ground.bounds());
  const glm::dmat4 to_clip =
      picture.camera.projection(size.x / size.y, depth_range) * picture.camera.view();
  const View view{picture, to_clip, size, scale, key_light(picture.camera)};

  Targets& pictures = targets(viewport, picture.quality);
  pictures.bind_main();
  glViewport(0, 0, viewport.width, viewport.height);
  set_initial_state();
  glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);

  marks_.take(view);
  ground_.draw_background(view);
  surfaces_.draw_opaque(view);
  ground_.draw_ground(view, ground, marks_);
  surfaces_.draw_translucent(view, pictures);
  marks_.draw_hidden(view);
  if (has(picture, &Surface::translucent)) surfaces_.add_translucent_depth(view);
  marks_.draw_visible(view);
  if (has(picture, &Surface::highlighted)) {
    surfaces_.mark_highlighted(view);
    marks_.draw_outlines(view);
  }
  pictures.show(viewport.x, frame_height - viewport.y - viewport.height);
  meshes_.sweep();
}

}  // namespace sectile::viewer
