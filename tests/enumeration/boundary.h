// The boundary of a set of cells, with every wedge of material on its own: where the set touches
// itself in an edge or a vertex, each wedge has its own edge and its own vertex.
#pragma once

#include <vector>

#include "complex.h"

namespace sectile::test {

/// How the boundary becomes a mesh.
enum class Meshing {
  shared,     ///< the cells' sides; one vertex per place: non-manifold where cells only touch
  wedges,     ///< the same with a vertex for each wedge of material
  triangles,  ///< the sides as triangles, one vertex per place
  own,        ///< the sides as triangles, each with three vertices of its own
  merged      ///< coplanar sides as one polygon where that is simple, a vertex for each wedge
};
inline constexpr Meshing all_meshings[] = {Meshing::shared, Meshing::wedges, Meshing::triangles,
                                           Meshing::own, Meshing::merged};

class Boundary {
 public:
  Boundary(const Complex& complex, Mask mask);

  PolygonMesh mesh(Meshing how) const;
  int shell_count() const { return shell_count_; }
  /// Summed over all shells.
  int genus() const { return genus_; }

 private:
  struct Face {
    const Complex::Side* side;
    int first;  ///< number of its first half-edge; they are numbered face by face
  };
  int next(int h) const;
  int point_of(int h) const;
  void find_partners(Mask mask, const std::vector<std::pair<int, int>>& sides);
  void count();
  std::vector<std::vector<int>> merged_polygons() const;
  bool trace_outline(const std::vector<int>& group, int g, std::vector<int>& outline) const;

  const Complex& complex_;
  std::vector<Face> faces_;
  std::vector<int> face_of_;  ///< of each half-edge
  std::vector<int> partner_;  ///< the half-edge on the other side of the wedge's edge
  std::vector<int> vertex_;   ///< of each half-edge's start: one number per wedge
  int vertex_count_ = 0, shell_count_ = 0, genus_ = 0;
};

}  // namespace sectile::test
