// Exact points and planes, in tables.
//
// A plane is given by three explicit points, or contains two explicit points and an axis direction
// (the plane that pins down an edge between coplanar faces), or has four doubles as coefficients.
// A point is explicit (three doubles), or three planes meet in it; if two of the planes meet in the
// line of an input edge, the end points of that edge are kept as well (line ∩ plane), because they
// give shorter numbers. No operation makes a new plane, so numbers never grow.
#pragma once

#include <array>
#include <vector>

#include "numbers/id.h"
#include "sectile/mesh.h"

namespace sectile {

/// The definition of a plane. Its normal is (b - a) × (c - a), pointing out of the material.
struct PlaneDefinition {
  enum class Kind : std::uint32_t { three_points, along_x, along_y, along_z, coefficients };
  /// The points a, b, c; along an axis: a, b and the kind; coefficients: an index in a.
  std::uint32_t a = 0, b = 0, c = 0;

  static constexpr std::uint32_t first_special = 0xFFFFFFF0u;
  Kind kind() const {
    return c < first_special ? Kind::three_points : static_cast<Kind>(c - first_special);
  }
  static PlaneDefinition through(PointId a, PointId b, PointId c) {
    return {a.value(), b.value(), c.value()};
  }
  /// Normal (b - a) × e_axis.
  static PlaneDefinition along_axis(PointId a, PointId b, int axis) {
    return {a.value(), b.value(), first_special + 1 + static_cast<std::uint32_t>(axis)};
  }
  static PlaneDefinition with_coefficients(std::uint32_t index) {
    return {index, 0, first_special + static_cast<std::uint32_t>(Kind::coefficients)};
  }
};

/// The construction of an implicit point.
struct Construction {
  PlaneId a, b, c;
  PointId line_from, line_to;  ///< explicit points of the line a ∩ b, or invalid
};

struct PlaneCoefficients {
  double a = 0, b = 0, c = 0, d = 0;  ///< a·x + b·y + c·z + d = 0
};

class Geometry {
 public:
  std::vector<Vec3> positions;           ///< explicit: exact; implicit: rounded to nearest
  std::vector<std::uint32_t> construct;  ///< per point: index into constructions, or explicit_point
  std::vector<Construction> constructions;
  std::vector<PlaneDefinition> planes;
  std::vector<PlaneCoefficients> coefficients;

  static constexpr std::uint32_t explicit_point = 0xFFFFFFFFu;

  bool is_explicit(PointId p) const { return construct[p.value()] == explicit_point; }
  const Vec3& position(PointId p) const { return positions[p.value()]; }
  const Construction& construction(PointId p) const { return constructions[construct[p.value()]]; }
  const PlaneDefinition& definition(PlaneId s) const { return planes[s.value()]; }

  PointId add_point(const Vec3& position) {
    positions.push_back(position);
    construct.push_back(explicit_point);
    return PointId(positions.size() - 1);
  }
  PointId add_point(const Construction& how, const Vec3& rounded) {
    positions.push_back(rounded);
    construct.push_back(static_cast<std::uint32_t>(constructions.size()));
    constructions.push_back(how);
    return PointId(positions.size() - 1);
  }
  PlaneId add_plane(const PlaneDefinition& definition) {
    planes.push_back(definition);
    return PlaneId(planes.size() - 1);
  }
  PlaneId add_plane(const PlaneCoefficients& plane) {
    coefficients.push_back(plane);
    return add_plane(
        PlaneDefinition::with_coefficients(static_cast<std::uint32_t>(coefficients.size() - 1)));
  }
};

}  // namespace sectile
