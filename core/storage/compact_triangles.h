// The triangles of a block in as few bytes as will do. Its structure and its geometry are made of
// them when they are first asked for: most blocks of a large import never are. They are written
// from these.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/geometry.h"
#include "topology/brep.h"

namespace sectile {

/// Half-edges and vertices have the numbers that they have in the block.
struct CompactTriangles {
  struct Triangle {
    std::array<std::uint16_t, 3> vertex;     ///< corners, counter-clockwise
    std::array<std::uint16_t, 3> half_edge;  ///< those that leave them
    std::uint32_t source;                    ///< FaceSource::face
  };
  struct BorderEdge {
    std::uint16_t corner;    ///< three times its triangle, and which of the half-edges it is
    std::uint16_t from, to;  ///< vertices: here, so that triangles are not looked up for them
  };
  std::vector<Vec3> positions;      ///< per vertex, in the order in which triangles meet them
  std::vector<Triangle> triangles;  ///< per face
  std::uint32_t half_edge_count = 0;
  std::vector<BorderEdge> border;  ///< per edge that leaves the block: see storage/block.h
  std::uint32_t origin = 0;        ///< FaceSource::solid
  /// The pieces that hang together over edges, numbered by their first triangles; 0 if nobody has
  /// looked.
  std::uint32_t piece_count = 0;
  std::vector<std::uint8_t> piece;  ///< per triangle; empty if there is one

  std::uint32_t piece_of(std::uint32_t triangle) const {
    return piece.empty() ? 0 : piece[triangle];
  }
};

Brep make_brep(const CompactTriangles& of);
/// Points are the vertices, planes the faces.
Geometry make_geometry(const CompactTriangles& of);

}  // namespace sectile
