// Exact points and planes, in tables.
//
// A point is given, or three planes meet in it (a constructed point). Given points are explicit
// (three doubles) or moved (three doubles in a frame, an exact affine map). A plane is given by
// three given points, or contains two of them and the direction of an axis (the plane that pins
// down an edge between coplanar faces) or of an axis that was moved, or has coefficients. If two
// planes of a constructed point meet in the line of an input edge, the end points of that edge are
// kept as well (line ∩ plane), because they give shorter numbers. No operation makes a new plane,
// so numbers grow with moves only.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "geometry/frame.h"
#include "geometry/shared_table.h"
#include "numbers/id.h"
#include "numbers/table.h"
#include "sectile/mesh.h"

namespace sectile {

/// The definition of a plane. Its normal is (b - a) × (c - a), pointing out of the material.
struct PlaneDefinition {
  enum class Kind : std::uint32_t {
    three_points,
    along_x,
    along_y,
    along_z,
    coefficients,
    exact_coefficients,
    along_direction
  };
  /// The points a, b, c; along an axis: a, b and the kind; coefficients: an index in a.
  std::uint32_t a = 0, b = 0, c = 0;

  static constexpr std::uint32_t first_special = 0xFFFFFFF0u, first_direction = 0xF0000000u;
  Kind kind() const {
    if (c < first_direction) return Kind::three_points;
    return c < first_special ? Kind::along_direction : static_cast<Kind>(c - first_special);
  }
  bool has_points() const {
    return kind() != Kind::coefficients && kind() != Kind::exact_coefficients;
  }
  /// Of a plane along a direction: its index.
  std::uint32_t direction() const { return c - first_direction; }
  static PlaneDefinition through(PointId a, PointId b, PointId c) {
    return {a.value(), b.value(), c.value()};
  }
  /// Normal (b - a) × e_axis.
  static PlaneDefinition along_axis(PointId a, PointId b, int axis) {
    return {a.value(), b.value(), first_special + 1 + static_cast<std::uint32_t>(axis)};
  }
  /// Normal (b - a) × direction.
  static PlaneDefinition along_direction(PointId a, PointId b, std::uint32_t index) {
    return {a.value(), b.value(), first_direction + index};
  }
  static PlaneDefinition with_coefficients(std::uint32_t index) {
    return {index, 0, first_special + static_cast<std::uint32_t>(Kind::coefficients)};
  }
  static PlaneDefinition with_exact_coefficients(std::uint32_t index) {
    return {index, 0, first_special + static_cast<std::uint32_t>(Kind::exact_coefficients)};
  }
};

/// The construction of an implicit point.
struct Construction {
  PlaneId a, b, c;
  PointId line_from, line_to;  ///< given points of the line a ∩ b, or invalid
};

/// A moved point: its frame maps three doubles to it.
struct MovedPoint {
  Vec3 local;
  std::uint32_t frame;
  friend bool operator==(const MovedPoint&, const MovedPoint&) = default;
};

/// The direction of an axis that was moved.
struct ExactDirection {
  ExactNumber d[3];
};

/// n · x + d = 0, where doubles cannot hold it.
struct ExactCoefficients {
  ExactNumber n[3], d;
};

struct PlaneCoefficients {
  double a = 0, b = 0, c = 0, d = 0;  ///< a·x + b·y + c·z + d = 0
};

class Geometry {
 public:
  Table<PointId, Vec3> positions;  ///< explicit: exact; others: rounded to nearest
  /// Per point: index into constructions; explicit_point; or moved_point and index into moved.
  Table<PointId, std::uint32_t> construct;
  UnsetVector<Construction> constructions;
  std::vector<MovedPoint> moved;
  Table<PlaneId, PlaneDefinition> planes;
  std::vector<PlaneCoefficients> coefficients;
  // Shared between solids; equal ones are one object as far as is known.
  SharedTable<Frame> frames;
  SharedTable<ExactDirection> directions;
  std::vector<std::shared_ptr<const ExactCoefficients>> exact_coefficients;

  static constexpr std::uint32_t explicit_point = 0xFFFFFFFFu, moved_point = 0x80000000u;

  bool is_explicit(PointId p) const { return construct[p] == explicit_point; }
  bool is_moved(PointId p) const {
    return !moved.empty() && construct[p] - moved_point < moved.size();
  }
  bool is_constructed(PointId p) const { return construct[p] < moved_point; }
  const MovedPoint& moved_point_of(PointId p) const { return moved[construct[p] - moved_point]; }
  const Vec3& position(PointId p) const { return positions[p]; }
  const Construction& construction(PointId p) const { return constructions[construct[p]]; }
  const PlaneDefinition& definition(PlaneId s) const { return planes[s]; }

  PointId add_point(const Vec3& position) {
    construct.add(explicit_point);
    return positions.add(position);
  }
  PointId add_point(const MovedPoint& how, const Vec3& rounded) {
    construct.add(moved_point | static_cast<std::uint32_t>(moved.size()));
    moved.push_back(how);
    return positions.add(rounded);
  }
  PointId add_point(const Construction& how, const Vec3& rounded) {
    construct.add(static_cast<std::uint32_t>(constructions.size()));
    constructions.push_back(how);
    return positions.add(rounded);
  }
  PlaneId add_plane(const PlaneDefinition& definition) { return planes.add(definition); }
  PlaneId add_plane(const PlaneCoefficients& plane) {
    coefficients.push_back(plane);
    return add_plane(
        PlaneDefinition::with_coefficients(static_cast<std::uint32_t>(coefficients.size() - 1)));
  }
};

}  // namespace sectile
