// Snapping: to a grid, to angles, and of a dragged solid's vertices, edges and faces to those of
// others so that they touch exactly. Pure functions.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "scene/exact_moves.h"
#include "scene/scene.h"
#include "sectile/box_search.h"

namespace sectile::viewer {

/// The nearest multiple of a step; steps that are not positive change nothing.
double snapped(double value, double step);
Vec3 snapped(const Vec3& value, double step);

/// What of solids others can be snapped to, in the world, as doubles, and the exact corners of the
/// solids that they are made of. `part` tells the solids of one drag apart.
struct SnapFeatures {
  using CornerIndex = std::uint32_t;
  struct Vertex {
    Vec3 point;
    CornerIndex corner = 0;
    std::uint32_t part = 0;
  };
  struct Edge {
    Vec3 from, to;
    std::array<CornerIndex, 2> corners{};
    std::uint32_t part = 0;
  };
  struct Face {
    Vec3 point, normal;                    ///< the normal has length one and points outwards
    Vec3 low, high;                        ///< the box around it
    std::array<CornerIndex, 3> corners{};  ///< of one of its triangles
    std::uint32_t part = 0;
  };
  std::vector<ExactCorner> corners;  ///< in the coordinates of the solid that they belong to
  std::vector<Vertex> vertices;      ///< ends of hard edges
  std::vector<Edge> edges;           ///< between faces of different direction
  std::vector<Face> faces;           ///< one for each plane and connected part
  void add(const SnapFeatures& more, std::uint32_t part);
};
/// Of a solid in its own coordinates (Evaluation::Entry::inside) that stands in the world so.
SnapFeatures snap_features(const Solid& inside, const Transform& world = {});

/// The features of a solid that stands still, found by their place.
class SnapTargets {
 public:
  /// `place`: from the coordinates of the corners to those that contacts are looked for in.
  SnapTargets(SnapFeatures all, ExactTransform place = {});
  const SnapFeatures& features() const { return features_; }
  const ExactTransform& place() const { return place_; }
  const BoxSearch& vertices() const { return vertices_; }
  const BoxSearch& edges() const { return edges_; }
  const BoxSearch& faces() const { return faces_; }
  /// The ends of the edges around a face, two for each.
  std::vector<Vec3> outline(const SnapFeatures::Face& face) const;

 private:
  SnapFeatures features_;
  ExactTransform place_;
  BoxSearch vertices_, edges_, faces_;
};

/// How far the drag may go: anywhere, or along one to three directions (of length one, at right
/// angles to each other).
using SnapDirections = std::vector<Vec3>;
SnapDirections all_directions();

struct Snap {
  enum class Kind : std::uint8_t {
    vertex_vertex,
    edge_edge,
    vertex_edge,
    edge_vertex,
    face_face,
    vertex_face,
    face_vertex
  };
  Kind kind = Kind::vertex_vertex;
  Vec3 offset;  ///< instead of the proposed one, rounded
  /// A point of the dragged solid, as it stood before the drag, and the point where it comes to be.
  Vec3 from, to;
  std::uint32_t part = 0;  ///< the dragged solid
  /// Corners of the dragged solid, in its own coordinates, and of the one standing still, whose
  /// place is `on_place`. The first of the one side comes onto the first of the other; all others
  /// are then level with them, if the contact is exact. Empty: a point between corners, `from` or
  /// `to`.
  std::vector<ExactCorner> moved, on;
  ExactTransform on_place;
  /// Coordinates of `from` that the contact fixes: all for points, that of the normal for faces
  /// along an axis, the other two for edges along one.
  Coordinates fixed{true, true, true};
  /// Are they what the contact needs? Not for slanted edges and planes: their points hardly ever
  /// are sums of doubles.
  bool is_expressible = true;
  std::size_t target = 0;   ///< which of the solids standing still
  std::vector<Vec3> shown;  ///< ends of its edges that take part; none for a vertex
};

struct Snaps {
  /// Points before edges before faces, then the nearest. Faces become flush, turned towards each
  /// other. Up to three faces are snapped one after the other, so that a block finds its corner;
  /// each is one entry, and the last entry's offset is the one to use. Empty if nothing is near.
  std::vector<Snap> contacts;
  bool gave_up = false;  ///< too much lies within reach to be compared while the pointer moves
};

/// The best contact within `reach` of where `offset` brings the dragged solids.
Snaps snap(const SnapFeatures& dragged, const std::vector<const SnapTargets*>& fixed,
           const Vec3& offset, double reach, const SnapDirections& directions = all_directions());

/// A node that is dragged: its placement before, the exact form of what its parent's coordinates
/// are in those of the contacts, and for each part of the drag the way from the part's coordinates
/// to the node's, if it belongs to this node.
struct DraggedNode {
  Placement start;
  ExactTransform parent;
  std::vector<std::optional<ExactTransform>> ways{ExactTransform()};
};

struct Landings {
  std::vector<Placement> placements;  ///< one for each node
  bool is_exact = false;              ///< all contacts are
};

/// The placements after a drag by `offset` with these contacts. Nodes whose parents are turned
/// alike move as one, so that what was flush among them stays flush.
Landings placed_by(const std::vector<DraggedNode>& nodes, const Vec3& offset,
                   const std::vector<Snap>& contacts);

}  // namespace sectile::viewer
