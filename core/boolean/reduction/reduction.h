// Phase 1: reduction (paper, section 5, steps 1 to 8). Finds all contacts of the two boundaries.
//
// Afterwards they meet only in places (points) and in open segments between neighbouring places.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "boolean/entity.h"
#include "boolean/ids.h"
#include "boolean/workspace.h"
#include "numbers/sign.h"
#include "numbers/unset_vector.h"
#include "sectile/errors.h"

namespace sectile {

using FacePairs = std::vector<std::pair<FaceId, FaceId>>;

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
  /// Of two faces: positive if normal(A) × normal(B) points from place[0] to place[1], negative if
  /// it points back. Zero if one of them is an edge.
  Sign sense = Sign::zero;

  /// Makes the places ascending.
  void put_in_order() {
    if (place[0] < place[1]) return;
    std::swap(place[0], place[1]);
    for (auto& of_operand : end) std::swap(of_operand[0], of_operand[1]);
    sense = -sense;
  }
};

using SegmentRecords = UnsetVector<SegmentRecord>;

/// All edges of both operands along one crowded line, and the faces that lie on both sides of it.
/// What they share is in no segment: a sweep along the line finds where each has to be divided.
struct Row {
  /// An edge, or a stretch in a face.
  struct Run {
    Operand operand;
    Entity carrier;
    std::uint32_t from, to;  ///< places of the row, ascending
    Entity end[2];           ///< what the operand has there: as a rule vertices
  };
  /// A place at which something of the other operand meets a run.
  struct Meeting {
    std::uint32_t place, run;
  };
  std::vector<PlaceId> places;  ///< as they follow each other along the line
  std::vector<Run> runs;        ///< those of A first; one is an edge
  std::vector<Meeting> meetings;
};

/// Where the two boundaries meet.
struct Contacts {
  Table<ContactId, Contact> contacts;  ///< as pairs of faces find them, crossings last
  Table<PlaceId, PointId> places;      ///< the point of each place
  SegmentRecords segments;             ///< of what shares one, all pairs, or enough of very many
  std::vector<Row> rows;

  PointId point(PlaceId place) const { return places[place]; }
};

/// Where pairs are missing that were left out at crowded lines and points, or as common
/// faces.
class NeedsAllPairs : public InternalError {
 public:
  using InternalError::InternalError;
};

/// The contacts of pairs of loaded faces that may meet. Vertices of the patches that are at one
/// place share one point afterwards.
Contacts reduce(Workspace& w, const FacePairs& candidates);

}  // namespace sectile
