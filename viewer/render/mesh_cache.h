// The buffers of surfaces, kept as long as someone holds the mesh.
#pragma once

#include <map>
#include <memory>

#include "picture/picture.h"
#include "render/gl_objects.h"

namespace sectile::viewer {

struct MeshBuffers {
  GlVertexArray triangles, hairlines;
  GlBuffer positions, normals, ends;
  GlTexture ends_texture;  ///< the ends of hard edges, for segment.vert
  GLsizei corners = 0, edge_ends = 0;
  double edge_length = 0;  ///< of hard edges, on average, in model units
  /// Denser meshes are marked by their colour alone: an outline of all their edges takes a second.
  bool can_be_outlined() const { return edge_ends <= 2 * 60000; }
};

class MeshCache {
 public:
  const MeshBuffers& buffers(const std::shared_ptr<const SurfaceMesh>& mesh);
  /// Drops what nobody holds any more.
  void sweep();

 private:
  struct Entry {
    std::weak_ptr<const SurfaceMesh> mesh;
    std::unique_ptr<MeshBuffers> buffers;
  };
  std::map<const SurfaceMesh*, Entry> entries_;
};

/// Fills a buffer with places (w is one) and lets shaders pull them from a buffer texture.
void fill_pulled(const GlBuffer& buffer, const GlTexture& texture,
                 const std::vector<glm::vec3>& places, GLenum usage);

}  // namespace sectile::viewer
