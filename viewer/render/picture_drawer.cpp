#include "render/picture_drawer.h"

#include <algorithm>

#include "render/read_pixels.h"

namespace sectile::viewer {
namespace {

constexpr int samples_at_rest = 4;
constexpr double occlusion_radius = 0.16;  // of the size of the scene

// A headlight, somewhat from the left and from above.
glm::dvec3 key_light(const Camera& camera) {
  return glm::normalize(-camera.forward() + 0.45 * camera.up() - 0.35 * camera.right());
}

bool has(const Picture& picture, bool Surface::*what) {
  return std::any_of(picture.surfaces.begin(), picture.surfaces.end(),
                     [&](const Surface& surface) { return surface.mesh && surface.*what; });
}

// Faces that what lies behind them is seen through; tints lie on nothing but the background.
bool has_blended(const Picture& picture) {
  return std::any_of(picture.surfaces.begin(), picture.surfaces.end(), [](const Surface& surface) {
    return surface.mesh && surface.faces && surface.translucent && !surface.yields;
  });
}

bool has_opaque_faces(const Picture& picture) {
  return std::any_of(picture.surfaces.begin(), picture.surfaces.end(), [](const Surface& surface) {
    return surface.mesh && surface.faces && !surface.translucent && !surface.is_tool;
  });
}

double size_of_scene(const Picture& picture) {
  const Bounds box = picture.bounds();
  return box.is_empty() ? 1 : box.radius();
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

Image PictureDrawer::draw_image(const Picture& picture, int width, int height, float scale) {
  Targets targets(width, height, samples_at_rest);
  paint(picture, {0, 0, width, height}, scale, targets);
  const GlTexture colour;
  const GlFramebuffer framebuffer;
  glBindTexture(GL_TEXTURE_2D, colour.id());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour.id(), 0);
  targets.show(0, 0, framebuffer.id());
  Image image = read_pixels(framebuffer.id(), width, height);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  meshes_.sweep();
  return image;
}

void PictureDrawer::paint(const Picture& picture, const Viewport& viewport, float scale,
                          Targets& targets) {
  const glm::dvec2 size(viewport.width, viewport.height);
  const Ground ground = Ground::of(picture, size);
  Bounds depth_range = picture.bounds();
  if (picture.surroundings.show_grid || picture.surroundings.show_axes)
    depth_range.add(ground.bounds());
  const Bounds shadow = picture.surroundings.show_shadow ? Shadow::place_of(picture) : Bounds();
  if (!shadow.is_empty()) depth_range.add(shadow);
  const glm::dmat4 projection = picture.camera.projection(size.x / size.y, depth_range);
  const View view{picture, projection * picture.camera.view(), size, scale,
                  key_light(picture.camera)};

  set_initial_state();
  if (!shadow.is_empty() && !view.is_fast()) shadow_.find(view);
  targets.bind_main();
  glViewport(0, 0, viewport.width, viewport.height);
  glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);

  marks_.take(view);
  ground_.draw_background(view);
  if (ground.is_upright()) ground_.draw_ground(view, ground, marks_);
  surfaces_.draw_opaque(view);
  if (!view.is_fast() && has_opaque_faces(picture))
    occlusion_.darken(view, projection, occlusion_radius * size_of_scene(picture), targets);
  // Handles come last, as outlines are not to run around them; but before what is seen through.
  const bool see_through = has_blended(picture);
  if (see_through) surfaces_.draw_tools(view);
  if (!shadow.is_empty()) shadow_.draw(view);
  if (!ground.is_upright()) ground_.draw_ground(view, ground, marks_);
  surfaces_.draw_tints(view);
  surfaces_.draw_translucent(view, targets);
  marks_.draw_hidden(view);
  if (has(picture, &Surface::translucent)) surfaces_.add_translucent_depth(view);
  marks_.draw_visible(view);
  outlines_.draw(view, targets);
  if (!see_through) {
    targets.bind_main();
    surfaces_.draw_tools(view);
  }
  ++work_.pictures;
  work_.samples += std::uint64_t(viewport.width) * std::uint64_t(viewport.height) *
                   (targets.is_multisampled() ? samples_at_rest : 1);
  work_.triangles = surfaces_.triangles_drawn();
}

}  // namespace sectile::viewer
