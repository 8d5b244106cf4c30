// Rows of edges along which a sweep goes (neighborhoods/row_sweep.h) instead of looking at all of
// them between any two places.
//
// That takes that nothing but edges runs along the line, and no face has two edges beside each
// other there: in a place where a face touches itself, all that it has there is divided. Who
// follows the phases is shown all stretches: then there are no crowded lines
// (boolean/crowded_lines.h).
#pragma once

#include <span>
#include <vector>

#include "boolean/reduction/places_along.h"
#include "boolean/reduction/reduction.h"

namespace sectile {

/// An edge of A of some records between edges, and all their ends.
EdgeId edge_of_a(std::span<const SegmentRecord> records);
std::vector<PlaceId> ends_of(std::span<const SegmentRecord> records);

class SweptRows {
 public:
#ifdef SECTILE_SMALL_BLOCKS  // for tests: short rows go this way, too
  static constexpr std::size_t least = 1;
#else
  static constexpr std::size_t least = 32;  // fewer records take no longer otherwise
#endif
  static bool may_be_swept(const Workspace& w) {
    return !w.patch[Operand::a].on_crowded_line.empty();
  }

  /// The segments that are found already are those in which not only edges meet.
  SweptRows(const Workspace& w, Contacts& found);

  /// Makes a row of all records between edges on one line, unless it cannot be swept. Only where
  /// there are crowded lines.
  bool add(std::span<const SegmentRecord> records);

 private:
  bool can_be_swept(std::span<const SegmentRecord> records) const;
  /// Ends of records, and where anything meets an edge.
  std::vector<PlaceId> all_places(std::span<const SegmentRecord> records) const;
  void add_runs(Operand s, std::span<const SegmentRecord> records, const PlacesAlong& places,
                Row& row) const;
  void add_meetings(const PlacesAlong& places, Row& row) const;
  bool faces_keep_apart(const Row& row) const;
  std::span<const PlaceId> met(Operand s, EdgeId edge) const;

  const Workspace& w_;
  Contacts& found_;
  PerOperand<Table<EdgeId, std::uint8_t>> is_in_face_;  // of the other solid
  PerOperand<std::vector<PlaceId>> met_;                // where something meets an edge, by edges
  PerOperand<std::vector<std::uint32_t>> first_met_;    // per edge, and the end
};

}  // namespace sectile
