// Phase 2: what lies around each contact segment, the half-planes of both operands, sorted around
// the line.
//
// This one sort decides all that the paper settles case by case in 6.1 and 6.2 (Tables II and III,
// figures 17 to 20): see docs/paper.md.
#pragma once

#include <span>
#include <vector>

#include "boolean/direction.h"
#include "boolean/reduction/reduction.h"
#include "boolean/tables.h"

namespace sectile {

/// A face or an edge that a contact segment runs in or along.
struct Carrier {
  Operand operand;
  Entity entity;
  Entity end[2];        ///< what the operand has at the two places
  bool along = true;    ///< an edge's even half-edge runs from place[0] to place[1]
  bool cut = false;     ///< its two sides have different fates, or end in different wedges
  Direction direction;  ///< of a face that is cut: in it, from place[0] to place[1]
};

/// One side of a face or of an edge at a contact segment: half of a plane around the line.
struct HalfPlane {
  Operand operand;
  bool forward;  ///< the boundary half-edge runs from place[0] to place[1]
  CarrierId carrier;
  FaceId face;
  PlaneId plane;
  Class cls = Class::out;
};

/// A contact segment with all that meets in it; of a row of edges, as much of one edge as has the
/// same neighbors all along (row_sweep.h).
struct Segment {
  PlaceId place[2];
  IdRange<CarrierId> carriers;
  IdRange<HalfPlaneId> half_planes;  ///< in counter-clockwise order
  PlaneId plane[2];  ///< two planes through the line; the second invalid if all are parallel
};

/// Two half-planes that bound one wedge of material of a result.
struct WedgePair {
  HalfPlaneId first, second;
};

/// The wedges of material of a result.
struct Wedges {
  std::vector<WedgePair> pairs;  ///< in the order of the segments, those of rows last
  /// Sides of cuts that go on where the side before them ends, in the same wedge: what is paired
  /// for that one is paired for them, too.
  std::vector<HalfPlaneId> continued;
};

struct Neighborhoods {
  Table<SegmentId, Segment> segments;
  Table<CarrierId, Carrier> carriers;
  Table<HalfPlaneId, HalfPlane> half_planes;
  std::vector<Wedges> wedges;  ///< per wanted operation
};

/// For which results the boundaries are cut. If no operation is wanted, the carriers between whose
/// sides the class changes are cut (the eight-way classification).
struct Wanted {
  std::span<const Operation> operations = {};
  bool of_complement = false;  ///< wedges are those of the result's complement
  bool all_pairs = false;      ///< nothing is left out along crowded lines
};

/// Sorts and classifies the half-planes of each segment, and finds for each wanted operation the
/// wedges of material, and which carriers they cut.
Neighborhoods find_neighborhoods(const Workspace& w, const Contacts& contacts,
                                 const Wanted& wanted);

}  // namespace sectile
