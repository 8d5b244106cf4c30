// Places where one edge or vertex of one operand meets one face of the other, and nothing else
// does: by far the most.
//
// Such a place is hardly ever within a segment. If it is, the piercing operand touches itself
// there, and the segment runs in the pierced face: the other operand has nothing but that face
// there, as faces of one solid do not overlap, and an edge of it would have made a contact of its
// own.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boolean/reduction/reduction.h"
#include "numbers/threshold.h"

namespace sectile {

class PiercedFaces {
 public:
  PiercedFaces(const Workspace& w, const Contacts& found);

  /// Of a loaded face: the places that may be within segments that run in it.
  std::span<const PlaceId> places(Operand solid, FaceId face) const {
    return of_[solid].places(face);
  }
  /// Places that may be within any segment, ascending: where more meets, and those of faces that
  /// very many pierce.
  const std::vector<PlaceId>& others() const { return others_; }

 private:
  struct OfOperand {
    std::vector<PlaceId> place;        // by face
    std::vector<std::uint32_t> first;  // per face: of its places; and the end

    std::span<const PlaceId> places(FaceId face) const {
      if (first.empty()) return {};
      const std::uint32_t from = first[face.value()], to = first[face.value() + 1];
      return to - from > most_places ? std::span<const PlaceId>()
                                     : std::span(place).subspan(from, to - from);
    }
  };
  // Faces that are pierced more often are searched as all else is.
  static constexpr std::uint32_t most_places = threshold(24, 1);

  void group(const Contacts& found, Operand s, std::size_t faces);

  Table<PlaceId, ContactId> only_;  // the contact of each place, if it has one, with a face
  PerOperand<OfOperand> of_;
  std::vector<PlaceId> others_;
};

}  // namespace sectile
