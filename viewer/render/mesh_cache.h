// The buffers of surfaces, kept as long as someone holds the mesh.
#pragma once

#include <map>
#include <memory>

#include "picture/picture.h"
#include "render/gl_objects.h"

namespace sectile::viewer {

struct EdgeBuffers {
  GlVertexArray hairlines;
  GlBuffer ends;
  GlTexture ends_texture;  ///< for segment.vert
  GLsizei count = 0;       ///< of ends
  double length = 0;       ///< of all together, in model units
};

struct MeshBuffers {
  GlVertexArray triangles;
  GlBuffer positions, normals;
  GLsizei corners = 0;
};

class MeshCache {
 public:
  const MeshBuffers& buffers(const std::shared_ptr<const SurfaceMesh>& mesh);
  const EdgeBuffers& hard_edges(const std::shared_ptr<const SurfaceMesh>& mesh);
  const EdgeBuffers& smooth_edges(const std::shared_ptr<const SurfaceMesh>& mesh);
  /// Drops what nobody holds any more.
  void sweep();

 private:
  struct Entry {
    std::weak_ptr<const SurfaceMesh> mesh;
    std::unique_ptr<MeshBuffers> buffers;
    std::unique_ptr<EdgeBuffers> hard, smooth;  // made when first asked for
  };
  Entry& entry(const std::shared_ptr<const SurfaceMesh>& mesh);
  std::map<const SurfaceMesh*, Entry> entries_;
};

/// Fills a buffer with places (w is one) and lets shaders pull them from a buffer texture.
void fill_pulled(const GlBuffer& buffer, const GlTexture& texture,
                 const std::vector<glm::vec3>& places, GLenum usage);

}  // namespace sectile::viewer
