// Snapping: to a grid, to angles, and of a dragged solid's vertices, edges and faces to those of
// others so that they touch exactly. Pure functions.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "scene/box_tree.h"
#include "scene/scene.h"

namespace sectile::viewer {

/// The nearest multiple of a step; steps that are not positive change nothing.
double snapped(double value, double step);
Vec3 snapped(const Vec3& value, double step);

/// What of solids others can be snapped to, in the world, as doubles. `local` points are the same
/// ones in the solid's own coordinates; `part` tells the solids of one drag apart.
struct SnapFeatures {
  struct Vertex {
    Vec3 point, local;
    std::uint32_t part = 0;
  };
  struct Edge {
    Vec3 from, to, local;  ///< `local` is `from`
    std::uint32_t part = 0;
  };
  struct Face {
    Vec3 point, local, normal;  ///< the normal has length one and points outwards
    Vec3 low, high;             ///< the box around it
    std::uint32_t part = 0;
  };
  std::vector<Vertex> vertices;  ///< ends of hard edges
  std::vector<Edge> edges;       ///< between faces of different direction
  std::vector<Face> faces;       ///< one for each plane and connected part
  void add(const SnapFeatures& more, std::uint32_t part);
};
/// Of a solid in its own coordinates (Evaluation::Entry::inside) that stands in the world so.
SnapFeatures snap_features(const Solid& inside, const Transform& world = {});

/// The features of a solid that stands still, found by their place.
class SnapTargets {
 public:
  SnapTargets(SnapFeatures all);
  const SnapFeatures& features() const { return features_; }
  const BoxTree& vertices() const { return vertices_; }
  const BoxTree& edges() const { return edges_; }
  const BoxTree& faces() const { return faces_; }
  /// The ends of the edges around a face, two for each.
  std::vector<Vec3> outline(const SnapFeatures::Face& face) const;

 private:
  SnapFeatures features_;
  BoxTree vertices_, edges_, faces_;
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
  Vec3 offset;  ///< instead of the proposed one; exact where a double can say it
  /// A point of the dragged solid, as it stood before the drag, and the point where it comes to be.
  Vec3 from, to;
  std::optional<Vec3> local;  ///< `from` in the solid's own coordinates, if it is one of its points
  std::uint32_t part = 0;     ///< the dragged solid
  /// Coordinates of `from` that the contact fixes: all for points, that of the normal for faces
  /// along an axis, the other two for edges along one.
  std::array<bool, 3> fixed{true, true, true};
  /// Are they what the contact needs? Not for slanted edges and planes, which hardly ever have
  /// doubles on them.
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

struct Landing {
  Placement placement;
  bool is_exact = false;  ///< the wanted coordinates are reached to the last bit
};

/// The placement moved so that `parent` · placement · `below` maps `local` onto `target` in the
/// coordinates chosen, to the last bit if there is a position that does. Only for parents that are
/// turned by other than right angles, positions may exist that are not found. `parent` is
/// Scene::world_of_parent; `below` leads from the solid's coordinates to the node's.
Landing moved_onto(const Placement& start, const Transform& parent, const Vec3& local,
                   const Vec3& target, const std::array<bool, 3>& fixed = {true, true, true},
                   const Transform& below = {});

/// The placement after a drag by `offset` with these contacts of its solids, each as above. Those
/// for which `below` holds nothing belong to other nodes, and only give the offset.
Landing placed_by(const Placement& start, const Transform& parent, const Vec3& offset,
                  const std::vector<Snap>& contacts,
                  const std::vector<std::optional<Transform>>& below = {Transform()});

}  // namespace sectile::viewer
