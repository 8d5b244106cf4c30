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

/// Very many edges of both solids along one line on which nothing else of them runs. They are in no
/// segment: a sweep along the line finds where each has to be divided.
struct Row {
  /// Where an edge runs beside edges of the other solid.
  struct Run {
    Operand operand;
    EdgeId edge;
    std::uint32_t from, to;  ///< places of the row
    Entity end[2];           ///< of the solid's closure there
  };
  /// A place between the ends of a run in which something of the other solid meets its edge.
  struct Meeting {
    std::uint32_t place, run;
  };
  std::vector<PlaceId> places;  ///< as they follow each other along the line
  std::vector<Run> runs;        ///< by operand and edge, then along the line
  std::vector<Meeting> meetings;
};

/// Where the two boundaries meet.
struct Contacts {
  Table<ContactId, Contact> contacts;   ///< as pairs of faces find them, crossings last
  Table<PlaceId, PointId> places;       ///< the point of each place
  std::vector<SegmentRecord> segments;  ///< of what shares one, all pairs, or enough of very many
  std::vector<Row> rows;
  bool has_unswept_rows = false;  ///< were RowsOf::lines asked for, and are some no rows?

  PointId point(PlaceId place) const { return places[place]; }
};

/// Of what along one line rows are made: of edges that hang together as one meets the other, or,
/// for a solid that is tested against itself, of all.
enum class RowsOf : std::uint8_t { edges_that_meet, lines };

/// The contacts of pairs of loaded faces that may meet. Vertices of the patches that are at one
/// place share one point afterwards.
Contacts reduce(Workspace& w, const FacePairs& candidates, RowsOf rows = RowsOf::edges_that_meet);

}  // namespace sectile
