// The plain records that the phases hand over. Solid 0 is A, solid 1 is B.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "boolean/entity.h"
#include "boolean/ids.h"
#include "boolean/operand.h"
#include "boolean/patch.h"

namespace sectile {

/// A place where the two boundaries meet in a point: one entity of each. Several contacts may be at
/// one place.
struct Contact {
  PerOperand<Entity> on;
  PointId point;
  PlaceId place;
};

/// A segment between two neighbouring places in which two entities meet (face or edge each).
struct SegmentRecord {
  PlaceId place[2];                       ///< ascending
  PerOperand<Entity> on;                  ///< the face or edge of each solid
  PerOperand<std::array<Entity, 2>> end;  ///< at each place: the entity of the solid's closure
};

/// Where a half-plane of one solid lies relative to the other.
enum class Class : std::uint8_t { in, out, on_plus, on_minus };

/// One side of a face or of an edge at a contact segment: half of a plane around the line.
struct HalfPlane {
  std::uint8_t solid;
  bool forward;           ///< the boundary half-edge runs from place[0] to place[1]
  std::uint32_t carrier;  ///< index in the segment's carriers
  FaceId face;
  PlaneId plane;
  Class cls = Class::out;
};

/// A face or an edge that a contact segment runs in or along.
struct Carrier {
  std::uint8_t solid;
  Entity entity;
  Entity end[2];      ///< what the solid has at the two places
  bool along = true;  ///< an edge's even half-edge runs from place[0] to place[1]
  bool cut = false;
  std::uint32_t cut_end[2];      ///< if cut: indices of its CutEnds
  HalfEdgeId forward, backward;  ///< if cut, after joining: the two sides, on real faces
};

/// A contact segment with all that meets in it.
struct Segment {
  PlaceId place[2];
  std::uint32_t first_carrier, carrier_count;
  std::uint32_t first_half_plane, half_plane_count;  ///< in counter-clockwise order
  PlaneId plane[2];  ///< two planes through the line; the second invalid if all are parallel
};

/// Two half-planes (indices) that bound one wedge of material of a result.
struct WedgePair {
  std::uint32_t first, second;
};

/// A place on one entity of one solid at which cuts end.
struct Site {
  std::uint8_t solid;
  Entity entity;
  PlaceId place;
  std::uint32_t first_end = 0, end_count = 0;  ///< its CutEnds, in counter-clockwise order
  VertexId vertex;                             ///< the vertex of the patch there
  HalfEdgeId forward;  ///< on an edge: the half-edge that goes on from there
};

/// One end of a cut.
struct CutEnd {
  std::uint32_t site;
  std::uint32_t segment, carrier;
  std::uint8_t which;  ///< at place[which] of its segment
  HalfEdgeId corner;   ///< of the patch, in which the cut leaves; invalid within a face
  /// The chain of null half-edges to which the cut is attached, or (last invalid) the corner.
  HalfEdgeId first, last;
};

}  // namespace sectile
