// Lines and points: edges, line segments, round marks.
#pragma once

#include "render/mesh_cache.h"
#include "render/shader_program.h"
#include "render/view.h"

namespace sectile::viewer {

/// Where an edge lies as seen by the camera.
enum class EdgePlace { behind_faces, inside_translucent, in_front };

class MarkDrawer {
 public:
  explicit MarkDrawer(MeshCache& meshes);

  /// To be called once for each picture, before the others.
  void take(const View& view);
  /// Seen through translucent faces or, faintly, through opaque ones; the depth is that of the
  /// opaque faces.
  void draw_hidden(const View& view);
  /// In front of all faces; the depth is that of all faces.
  void draw_visible(const View& view);
  /// A line of its own, as part of the surroundings.
  void draw_line(const View& view, const std::vector<glm::vec3>& ends, const Colour& colour,
                 float width);

 private:
  struct Pulled {
    GlBuffer buffer;
    GlTexture texture;
    GLsizei count = 0;
  };
  struct Stroke {
    Colour colour;
    float width = 1;
    glm::dmat4 model{1};
  };
  void draw_edges(const View& view, EdgePlace place);
  void draw_edges(const View& view, const Surface& surface, const EdgeBuffers& edges,
                  EdgePlace place);
  void draw_lines(const View& view, float strength, float on_top_strength);
  void draw_points(const View& view, bool hidden);
  void draw_segments(const View& view, GLuint texture, GLsizei ends, const Stroke& stroke);
  void draw_hairlines(const View& view, const EdgeBuffers& edges, const Stroke& stroke);
  static void fill(std::vector<Pulled>& pool, std::size_t index,
                   const std::vector<glm::vec3>& places);

  MeshCache& meshes_;
  ShaderProgram segment_, hairline_, point_;
  GlVertexArray nothing_;  // for shaders that pull their vertices
  std::vector<Pulled> lines_, points_, own_;
  bool hairlines_only_ = false;
  bool has_translucent_ = false;
};

}  // namespace sectile::viewer
