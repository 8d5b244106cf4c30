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
  glCullFace(GL_BACK);
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

PictureDrawer::Kept& PictureDrawer::kept(const Viewport& viewport, Quality quality) {
  Kept& kept = quality == Quality::fast ? fast_ : full_;
  if (!kept.targets || kept.targets->width() != viewport.width ||
      kept.targets->height() != viewport.height) {
    kept = {};
    kept.targets = std::make_unique<Targets>(viewport.width, viewport.height,
                                             quality == Quality::fast ? 1 : samples_at_rest);
  }
  return kept;
}

void PictureDrawer::draw(const Picture& picture, const Viewport& viewport, int frame_height,
                         float scale) {
  if (viewport.width <= 0 || viewport.height <= 0) return;
  Kept& kept = this->kept(viewport, picture.quality);
  // While only the interface changes, the picture is shown again.
  if (!kept.drawn || kept.scale != scale || !(*kept.drawn == picture)) {
    paint(picture, viewport, scale, *kept.targets);
    kept.drawn = picture;
    kept.scale = scale;
    // Meshes that are no longer shown are not kept by the other picture.
    (picture.quality == Quality::fast ? full_ : fast_).drawn.reset();
  }
  kept.targets->show(viewport.x, frame_height - viewport.y - viewport.height);
  meshes_.sweep();
}

void PictureDrawer::paint(const Picture& picture, const Viewport& viewport, float scale,
                          Targets& targets) {
  const glm::dvec2 size(viewport.width, viewport.height);
  const Ground ground = Ground::of(picture, size);
  Bounds depth_range = picture.bounds();
  if (picture.surroundings.show_grid || picture.surroundings.show_axes)
    depth_range.add(ground.bounds());
  const glm::dmat4 to_clip =
      picture.camera.projection(size.x / size.y, depth_range) * picture.camera.view();
  const View view{picture, to_clip, size, scale, key_light(picture.camera)};

  targets.bind_main();
  glViewport(0, 0, viewport.width, viewport.height);
  set_initial_state();
  glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);

  marks_.take(view);
  ground_.draw_background(view);
  surfaces_.draw_opaque(view);
  ground_.draw_ground(view, ground, marks_);
  surfaces_.draw_translucent(view, targets);
  marks_.draw_hidden(view);
  if (has(picture, &Surface::translucent)) surfaces_.add_translucent_depth(view);
  marks_.draw_visible(view);
  if (has(picture, &Surface::highlighted)) {
    surfaces_.mark_highlighted(view);
    marks_.draw_outlines(view);
  }
}

}  // namespace sectile::viewer
