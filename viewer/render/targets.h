// The off-screen pictures that a frame is made in.
#pragma once

#include <array>
#include <memory>

#include "render/gl_objects.h"
#include "render/renderer.h"

namespace sectile::viewer {

/// Colour, depth with stencil, and two more depths for peeling, of one size and sample count.
class Targets {
 public:
  Targets(int width, int height, int samples);

  int width() const { return width_; }
  int height() const { return height_; }
  bool is_multisampled() const { return samples_ > 1; }

  /// Colour and the depth of opaque surfaces.
  void bind_main() const;
  /// The same colour with one of the depths for peeling (made when first asked for).
  void bind_layer(int which);
  /// Binds the depth of the opaque surfaces (-1) or of a layer for reading by shaders.
  void bind_depth_texture(int which) const;
  /// Copies a part of the colour, or the depth, without its samples, and binds the copy for reading
  /// by shaders. What is drawn goes to the main picture again.
  void bind_flat_colour(int x, int y, int width, int height);
  void bind_flat_depth();
  /// Copies the colour into a frame buffer (0: that of the context); the place is from the lower
  /// left.
  void show(int x, int y, GLuint into = 0);

 private:
  GLenum kind() const { return is_multisampled() ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D; }
  void allocate(const GlTexture& texture, GLenum format) const;

  int width_, height_, samples_;
  GlTexture colour_, depth_;
  GlFramebuffer main_;
  struct Layer {
    GlTexture depth;
    GlFramebuffer framebuffer;
  };
  std::array<std::unique_ptr<Layer>, 2> layers_;
  // Without samples.
  struct Flat {
    GlTexture texture;
    GlFramebuffer framebuffer;
  };
  Flat& flat(std::unique_ptr<Flat>& one, GLenum format);
  void flatten(const Flat& to, int x, int y, int width, int height, GLenum what) const;
  std::unique_ptr<Flat> flat_colour_, flat_depth_;  // made when first asked for
};

}  // namespace sectile::viewer
