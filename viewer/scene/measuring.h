// Distances, angles and radii between vertices, edges and faces, for the eye: in doubles.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/snapping.h"

namespace sectile::viewer {

/// A vertex, an edge or a plane face in the world.
struct Measured {
  enum class Kind : std::uint8_t { vertex, edge, face };
  Kind kind = Kind::vertex;
  Vec3 point;                 ///< the vertex; a point of the face
  Vec3 from, to;              ///< the edge
  Vec3 normal;                ///< of the face, of length one
  std::vector<Vec3> outline;  ///< of the face, two ends for each edge
};

struct Measurement {
  struct Fact {
    std::string name;
    double value = 0;
    bool is_angle = false;  ///< in degrees; else a length
  };
  std::vector<Fact> facts;
  std::vector<Vec3> shown;  ///< the two ends of the distance, if there is one to show
};

Measurement measured(const Measured& thing);
Measurement measured(const Measured& a, const Measured& b);

/// A circle on which the corners of a chain of edges lie.
struct Circle {
  Vec3 centre, normal;
  double radius = 0;
  std::size_t corners = 0;
  bool is_closed = false;
};
/// The circle of the longest such chain through an edge, of five corners or more.
std::optional<Circle> circle_through(const SnapFeatures& features, std::size_t edge);

}  // namespace sectile::viewer
