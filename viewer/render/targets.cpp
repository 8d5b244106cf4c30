#include "render/targets.h"

#include <stdexcept>

namespace sectile::viewer {
namespace {

void check_complete() {
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw std::runtime_error("This OpenGL cannot draw into pictures of the kind that is needed");
}

}  // namespace

Targets::Targets(int width, int height, int samples)
    : width_(width), height_(height), samples_(samples) {
  allocate(colour_, GL_RGBA8);
  allocate(depth_, GL_DEPTH24_STENCIL8);
  glBindFramebuffer(GL_FRAMEBUFFER, main_.id());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, kind(), colour_.id(), 0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, kind(), depth_.id(), 0);
  check_complete();
}

void Targets::allocate(const GlTexture& texture, GLenum format) const {
  glBindTexture(kind(), texture.id());
  if (is_multisampled()) {
    glTexImage2DMultisample(kind(), samples_, format, width_, height_, GL_TRUE);
    return;
  }
  const bool is_depth = format == GL_DEPTH24_STENCIL8;
  glTexImage2D(kind(), 0, static_cast<GLint>(format), width_, height_, 0,
               is_depth ? GL_DEPTH_STENCIL : GL_RGBA,
               is_depth ? GL_UNSIGNED_INT_24_8 : GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(kind(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(kind(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void Targets::bind_main() const {
  glBindFramebuffer(GL_FRAMEBUFFER, main_.id());
}

void Targets::bind_layer(int which) {
  auto& layer = layers_.at(static_cast<std::size_t>(which));
  if (!layer) {
    layer = std::make_unique<Layer>();
    allocate(layer->depth, GL_DEPTH24_STENCIL8);
    glBindFramebuffer(GL_FRAMEBUFFER, layer->framebuffer.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, kind(), colour_.id(), 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, kind(), layer->depth.id(),
                           0);
    check_complete();
  }
  glBindFramebuffer(GL_FRAMEBUFFER, layer->framebuffer.id());
}

void Targets::bind_depth_texture(int which) const {
  glBindTexture(kind(),
                which < 0 ? depth_.id() : layers_.at(static_cast<std::size_t>(which))->depth.id());
}

Targets::Flat& Targets::flat(std::unique_ptr<Flat>& one, GLenum format) {
  if (one) return *one;
  one = std::make_unique<Flat>();
  const bool is_depth = format == GL_DEPTH24_STENCIL8;
  glBindTexture(GL_TEXTURE_2D, one->texture.id());
  glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), width_, height_, 0,
               is_depth ? GL_DEPTH_STENCIL : GL_RGBA,
               is_depth ? GL_UNSIGNED_INT_24_8 : GL_UNSIGNED_BYTE, nullptr);
  const GLint filter = is_depth ? GL_NEAREST : GL_LINEAR;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glBindFramebuffer(GL_FRAMEBUFFER, one->framebuffer.id());
  glFramebufferTexture2D(GL_FRAMEBUFFER,
                         is_depth ? GL_DEPTH_STENCIL_ATTACHMENT : GL_COLOR_ATTACHMENT0,
                         GL_TEXTURE_2D, one->texture.id(), 0);
  if (is_depth) {
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
  }
  check_complete();
  return *one;
}

void Targets::flatten(const Flat& to, int x, int y, int width, int height, GLenum what) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, main_.id());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to.framebuffer.id());
  glBlitFramebuffer(x, y, x + width, y + height, x, y, x + width, y + height, what, GL_NEAREST);
}

void Targets::bind_flat_colour(int x, int y, int width, int height) {
  const Flat& copy = flat(flat_colour_, GL_RGBA8);
  flatten(copy, x, y, width, height, GL_COLOR_BUFFER_BIT);
  bind_main();
  glBindTexture(GL_TEXTURE_2D, copy.texture.id());
}

void Targets::bind_flat_depth() {
  const Flat& copy = flat(flat_depth_, GL_DEPTH24_STENCIL8);
  flatten(copy, 0, 0, width_, height_, GL_DEPTH_BUFFER_BIT);
  bind_main();
  glBindTexture(GL_TEXTURE_2D, copy.texture.id());
}

void Targets::show(int x, int y, GLuint into) {
  GLuint from = main_.id();
  if (is_multisampled()) {
    const Flat& copy = flat(flat_colour_, GL_RGBA8);
    flatten(copy, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT);
    from = copy.framebuffer.id();
  }
  glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, into);
  glBlitFramebuffer(0, 0, width_, height_, x, y, x + width_, y + height_, GL_COLOR_BUFFER_BIT,
                    GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace sectile::viewer
