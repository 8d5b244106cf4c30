#include "render/occlusion.h"

#include <algorithm>

namespace sectile::viewer {
namespace {

constexpr float most_pixels = 90;  // of the radius, at 100 % scale

// What shaders need to find places from depths.
void set_unprojection(ShaderProgram& program, const Camera& camera, const glm::dmat4& p) {
  program.set("unproject", glm::vec4(1 / p[0][0], 1 / p[1][1], p[2][2], p[3][2]));
  program.set("parallel", camera.orthographic ? 1 : 0);
}

}  // namespace

Occlusion::Occlusion()
    : find_("whole_picture.vert", "occlusion.frag"),
      blur_("whole_picture.vert", "occlusion_blur.frag"),
      apply_("whole_picture.vert", "occlusion_apply.frag") {}

void Occlusion::resize(int width, int height) {
  if (width == width_ && height == height_) return;
  width_ = width;
  height_ = height;
  for (const Half* half : {&found_, &blurred_}) {
    glBindTexture(GL_TEXTURE_2D, half->texture.id());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RG16F, width, height, 0, GL_RG, GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, half->framebuffer.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, half->texture.id(),
                           0);
  }
}

void Occlusion::darken(const View& view, const glm::dmat4& projection, double radius,
                       Targets& targets) {
  const int width = targets.width(), height = targets.height();
  resize((width + 1) / 2, (height + 1) / 2);
  glDisable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  glBindVertexArray(nothing_.id());

  targets.bind_flat_depth();
  glBindFramebuffer(GL_FRAMEBUFFER, found_.framebuffer.id());
  glViewport(0, 0, width_, height_);
  find_.use();
  find_.set("depths", 0);
  set_unprojection(find_, view.picture.camera, projection);
  find_.set("radius", static_cast<float>(radius));
  find_.set("pixels", static_cast<float>(radius * projection[1][1] * height / 2));
  find_.set("most_pixels", most_pixels * view.scale);
  glDrawArrays(GL_TRIANGLES, 0, 3);

  glBindFramebuffer(GL_FRAMEBUFFER, blurred_.framebuffer.id());
  glBindTexture(GL_TEXTURE_2D, found_.texture.id());
  blur_.use();
  blur_.set("light", 0);
  glDrawArrays(GL_TRIANGLES, 0, 3);

  targets.bind_flat_depth();
  glViewport(0, 0, width, height);
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, blurred_.texture.id());
  glActiveTexture(GL_TEXTURE0);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_ZERO, GL_SRC_COLOR, GL_ZERO, GL_ONE);
  apply_.use();
  apply_.set("depths", 0);
  apply_.set("light", 1);
  set_unprojection(apply_, view.picture.camera, projection);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
  glEnable(GL_DEPTH_TEST);
}

}  // namespace sectile::viewer
