// Handles in the picture that move, turn and scale: where they are, which one is under the pointer,
// what a drag of one does. Knows no input and no OpenGL.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "picture/picture.h"
#include "scene/scene.h"

namespace sectile::viewer {

enum class HandleMode : std::uint8_t { move, rotate, scale };

/// Axes, planes (named by the axis at right angles to them), rings (by their axis), and the centre:
/// moving in the plane of the screen, turning about the line of sight, scaling all alike.
enum class HandlePart : std::uint8_t {
  axis_x,
  axis_y,
  axis_z,
  plane_x,
  plane_y,
  plane_z,
  ring_x,
  ring_y,
  ring_z,
  centre
};

struct Handles {
  HandleMode mode = HandleMode::move;
  glm::dvec3 origin{0};
  glm::dmat3 axes{1};  ///< columns of length one
  double size = 1;     ///< length of an axis in the world

  /// At a node's origin, along the world's axes or the node's own, `pixels` long on the screen.
  static Handles at(HandleMode mode, const Transform& world, bool local_axes, const Camera& camera,
                    glm::dvec2 picture_size, double pixels = 90);
  /// What is within `reach` pixels of a pixel, the nearest to the eye first.
  std::optional<HandlePart> part_at(const Camera& camera, glm::dvec2 pixel, glm::dvec2 picture_size,
                                    double reach = 7) const;
  /// A place at which part_at finds the part, unless one nearer to the eye is before it.
  glm::dvec3 grip(HandlePart part, const Camera& camera) const;
};

/// What to draw; `active` is shown brighter. It is drawn smaller and nearer to the eye, where it
/// looks the same, so that nothing within `scene` hides it.
struct HandlePicture {
  std::vector<Lines> lines;
  std::vector<Surface> surfaces;
  std::vector<Points> points;
};
HandlePicture draw(const Handles& handles, std::optional<HandlePart> active, const Camera& camera,
                   const Bounds& scene = {});

/// What a drag amounts to, in the world.
struct HandleChange {
  glm::dvec3 move{0};
  glm::dvec3 axis{0, 0, 1};  ///< of the turn, through the handles' origin
  double degrees = 0;
  glm::dvec3 scale{1};  ///< along the handles' axes
};

/// A drag of one part, from the ray under the pointer when it began.
class HandleDrag {
 public:
  HandleDrag(const Handles& handles, HandlePart part, const Ray& start, const Camera& camera);
  /// Where it is now. Rays that say nothing (say, parallel to the dragged axis) repeat the last
  /// change.
  HandleChange change(const Ray& now);
  HandlePart part() const { return part_; }
  /// The directions in which a move may go, for snapping.
  std::vector<Vec3> directions() const;

 private:
  std::optional<glm::dvec3> place(const Ray& ray) const;  // on the axis or the plane of the part
  glm::dvec3 moved(const glm::dvec3& place) const;
  HandleChange turned(const glm::dvec3& place);
  HandleChange scaled(const glm::dvec3& place) const;

  Handles handles_;
  HandlePart part_;
  glm::dvec3 direction_{0}, start_{0}, sight_{0}, up_{0};
  double last_angle_ = 0, turns_ = 0;
  HandleChange last_;
};

/// A placement after a change. Moves in a parent that is not turned, turns about axes that the
/// order of rotations leaves free, and right angles are exact. Scale factors go to
/// the axes of the node that are nearest to the axes of the handles. What is turned or scaled also
/// moves if the handles do not stand at its own origin.
Placement changed(const Placement& start, const Transform& parent, const Handles& handles,
                  const HandleChange& change);

}  // namespace sectile::viewer
