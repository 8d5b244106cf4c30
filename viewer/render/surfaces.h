// The faces of surfaces: opaque ones, translucent ones in exact order, and their depth.
#pragma once

#include <cstdint>

#include "render/mesh_cache.h"
#include "render/shader_program.h"
#include "render/targets.h"
#include "render/view.h"

namespace sectile::viewer {

class SurfaceDrawer {
 public:
  explicit SurfaceDrawer(MeshCache& meshes);

  /// Handles apart: they are drawn when the light is done.
  void draw_opaque(const View& view);
  void draw_tools(const View& view);
  /// Translucent surfaces that yield: their front faces, where no opaque face is in their place.
  void draw_tints(const View& view);
  /// Too dense to be drawn once more than need be while something moves.
  bool is_dense(const Surface& surface);
  /// The depth of what casts shadows, alone, as `to_clip` has it.
  void draw_casters(const View& view, const glm::dmat4& to_clip);
  /// Over what the targets hold.
  void draw_translucent(const View& view, Targets& targets);
  /// Adds the depth of the translucent faces to that of the opaque ones.
  void add_translucent_depth(const View& view);
  /// Sets alpha to one where the surface is and leaves the colour: everywhere, or where nothing
  /// hides it.
  void draw_mask(const View& view, const Surface& surface, bool through);

  /// In all passes, since the drawer was made.
  std::uint64_t triangles_drawn() const { return triangles_drawn_; }

 private:
  enum class Which { opaque, tools, tints, translucent };
  void set_place(ShaderProgram& program, const View& view, const glm::dmat4& to_clip,
                 const Surface& surface, double shift);
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
  ShaderProgram shaded_, depth_only_, mask_, peel_, peel_multisampled_;
  GlQuery any_pixel_;
  std::uint64_t triangles_drawn_ = 0;
};

}  // namespace sectile::viewer
