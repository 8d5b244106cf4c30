// Snapping: to a grid, to angles, and of a dragged solid's vertices, edges and faces to those of
// others so that they touch exactly. Pure functions.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "scene/scene.h"

namespace sectile::viewer {

/// The nearest multiple of a step; steps that are not positive change nothing.
double snapped(double value, double step);
Vec3 snapped(const Vec3& value, double step);

/// What of a solid others can be snapped to, in the world, as doubles. `local` points are the same
/// ones in the solid's own coordinates.
struct SnapFeatures {
  struct Vertex {
    Vec3 point, local;
  };
  struct Edge {
    Vec3 from, to, local;  ///< `local` is `from`
  };
  struct Face {
    Vec3 point, local, normal;  ///< the normal has length one and points outwards
    Vec3 low, high;             ///< the box around it
  };
  std::vector<Vertex> vertices;  ///< ends of hard edges
  std::vector<Edge> edges;       ///< between faces of different direction
  std::vector<Face> faces;       ///< one for each plane and connected part
};
/// Of a solid in its own coordinates (Evaluation::Entry::inside) that stands in the world so.
SnapFeatures snap_features(const Solid& inside, const Transform& world = {});

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
  /// Coordinates of `from` that the contact fixes: all for points, that of the normal for faces
  /// along an axis.
  std::array<bool, 3> fixed{true, true, true};
};

/// The best contact within `reach` of where `offset` brings the dragged solid: points before edges
/// before faces, then the nearest. Faces become flush, turned towards each other. Up to three faces
/// are snapped one after the other, so that a block finds its corner; each is one entry, and the
/// last entry's offset is the one to use. Empty if nothing is near.
std::vector<Snap> snap(const SnapFeatures& dragged, const SnapFeatures& fixed, const Vec3& offset,
                       double reach, const SnapDirections& directions = all_directions());

/// The placement moved so that Scene::world maps `local` onto `target` in the coordinates chosen,
/// to the last bit where doubles allow it. `parent` is Scene::world_of_parent.
Placement moved_onto(const Placement& start, const Transform& parent, const Vec3& local,
                     const Vec3& target, const std::array<bool, 3>& fixed = {true, true, true});

/// For dragged solids that are known in the world: the placement after a drag by `offset` with
/// these snaps, exact as above.
Placement placed_by(const Placement& start, const Transform& parent, const Vec3& offset,
                    const std::vector<Snap>& snaps);

}  // namespace sectile::viewer
