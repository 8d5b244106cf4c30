// The faces of surfaces: opaque ones, translucent ones in exact order, and their depth.
#pragma once

#include "render/mesh_cache.h"
#include "render/shader_program.h"
#include "render/targets.h"
#include "render/view.h"

namespace sectile::viewer {

class SurfaceDrawer {
 public:
  explicit SurfaceDrawer(MeshCache& meshes);

  void draw_opaque(const View& view);
  /// Over what the targets hold.
  void draw_translucent(const View& view, Targets& targets);
  /// Adds the depth of the translucent faces to that of the opaque ones.
  void add_translucent_depth(const View& view);
  /// Sets the stencil to one where a highlighted surface is, whatever hides it.
  void mark_highlighted(const View& view);

 private:
  enum class Which { opaque, translucent };
  void set_place(ShaderProgram& program, const View& view, const Surface& surface, double shift);
  void set_look(ShaderProgram& program, const View& view, const Surface& surface);
  void draw_all(ShaderProgram& program, const View& view, Which which);
  void draw_one(const Surface& surface);
  GLsizei translucent_corners(const View& view);
  /// In motion, where peeling takes too long: neither exact nor with depth.
  bool is_sorted(const View& view);
  bool is_drawn(const Surface& surface, Which which) const;
  void peel(const View& view, Targets& targets);
  void draw_sorted(const View& view);

  MeshCache& meshes_;
  ShaderProgram shaded_, depth_only_, peel_, peel_multisampled_;
  GlQuery any_pixel_;
};

}  // namespace sectile::viewer
