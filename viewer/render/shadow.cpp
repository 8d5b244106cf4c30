#include "render/shadow.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

namespace sectile::viewer {
namespace {

constexpr int resolution = 256;
constexpr float strength = 0.5f;
// Of the size of what casts: how far the shadow reaches, and how high things still cast one.
constexpr double reach = 0.28, height = 0.5;

bool casts(const Surface& surface) {
  return surface.mesh && surface.faces && !surface.translucent && !surface.is_tool &&
         !surface.mesh->bounds.is_empty();
}

// The ground lies at zero where things stand on it or above it, and under what reaches below.
double ground_below(const Bounds& box) {
  return std::min(0.0, box.low.z);
}

void prepare(const GlTexture& texture, GLint format, GLenum kind, GLenum type) {
  glBindTexture(GL_TEXTURE_2D, texture.id());
  glTexImage2D(GL_TEXTURE_2D, 0, format, resolution, resolution, 0, kind, type, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

}  // namespace

Shadow::Shadow(SurfaceDrawer& surfaces)
    : surfaces_(surfaces),
      blur_("whole_picture.vert", "shadow_blur.frag"),
      draw_("shadow.vert", "shadow.frag") {
  prepare(heights_, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT);
  prepare(shadow_, GL_R8, GL_RED, GL_UNSIGNED_BYTE);
  glBindFramebuffer(GL_FRAMEBUFFER, below_.id());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, heights_.id(), 0);
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
  glBindFramebuffer(GL_FRAMEBUFFER, blurred_.id());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, shadow_.id(), 0);
}

Bounds Shadow::place_of(const Picture& picture) {
  Picture casting;
  for (const Surface& surface : picture.surfaces)
    if (casts(surface)) casting.surfaces.push_back(surface);
  Bounds box = casting.bounds();
  if (box.is_empty()) return box;
  const double size = std::max(box.radius(), 1e-9), ground = ground_below(box);
  const glm::dvec3 around(2 * reach * size, 2 * reach * size, 0);
  box.low -= around;
  box.high += around;
  box.low.z = ground;
  box.high.z = ground + height * size;
  return box;
}

Shadow::Found Shadow::wanted(const Picture& picture) {
  Found wanted;
  wanted.section = picture.section;
  for (const Surface& surface : picture.surfaces)
    if (casts(surface)) wanted.casters.push_back({surface.mesh, surface.model});
  return wanted;
}

void Shadow::find(const View& view) {
  Found found = wanted(view.picture);
  if (found_ == found) return;
  place_ = place_of(view.picture);
  found_ = std::move(found);
  if (place_.is_empty()) return;
  glViewport(0, 0, resolution, resolution);
  glBindFramebuffer(GL_FRAMEBUFFER, below_.id());
  glClear(GL_DEPTH_BUFFER_BIT);
  // Seen from below: depth grows with the height above the ground.
  const glm::dvec3 extent = place_.high - place_.low;
  glm::dmat4 to_clip(1);
  for (int i = 0; i < 3; ++i) {
    to_clip[i][i] = 2 / extent[i];
    to_clip[3][i] = -1 - 2 * place_.low[i] / extent[i];
  }
  surfaces_.draw_casters(view, to_clip);

  glBindFramebuffer(GL_FRAMEBUFFER, blurred_.id());
  glDisable(GL_DEPTH_TEST);
  glBindTexture(GL_TEXTURE_2D, heights_.id());
  glBindVertexArray(nothing_.id());
  blur_.use();
  blur_.set("heights", 0);
  const double radius = (extent.z / height) * reach;
  blur_.set("reach", static_cast<float>(radius / std::max(extent.x, extent.y)));
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glEnable(GL_DEPTH_TEST);
}

void Shadow::draw(const View& view) {
  if (place_.is_empty() || view.picture.camera.position().z <= place_.low.z) return;
  if (!found_ || !(*found_ == wanted(view.picture))) return;
  draw_.use();
  draw_.set("to_clip", glm::mat4(view.to_clip));
  draw_.set("low", glm::vec3(place_.low));
  draw_.set("extent", glm::vec2(place_.high - place_.low));
  draw_.set("depth_shift", 4e-4f);
  draw_.set("strength", strength);
  draw_.set("shadow", 0);
  glBindTexture(GL_TEXTURE_2D, shadow_.id());
  glEnable(GL_BLEND);
  glDepthMask(GL_FALSE);
  glBindVertexArray(nothing_.id());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

}  // namespace sectile::viewer
