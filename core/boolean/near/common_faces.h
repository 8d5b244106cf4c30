// Faces that both boundaries have, corner by corner: of two versions of a part, nearly all.
//
// Where all faces at the corners of such a face are common, too, and nothing else touches it, one
// boundary is the other. What they have in common is all that meets there: nothing is cut, and it
// is known what one is to the other. The face lies deep in what is common, and is neither loaded
// nor tested. Other common faces, at the rim, are loaded as all faces are: their edges to what is
// deep have no segments, and over these their labels lead on to it.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "boolean/operand.h"
#include "boolean/tables.h"
#include "search/place_set.h"
#include "storage/solid_data.h"

namespace sectile {

struct Workspace;

/// Slots of each solid that may meet the other one, ascending.
using SlotsOfBoth = PerOperand<std::span<const std::uint32_t>>;

/// Is it worth while to look for common faces? Of a sample, some are.
bool seem_to_have_common_faces(const SolidData& a, const SolidData& b, const SlotsOfBoth& slots);

class CommonFaces {
 public:
  /// None.
  CommonFaces() = default;
  /// Those that are deep, if nothing touches them but what has their corners.
  CommonFaces(const Workspace& w, const SolidData& a, const SolidData& b, const SlotsOfBoth& slots);

  using Faces = std::vector<std::pair<Operand, FaceId>>;
  /// Something may touch these. They are at the rim from now on, with what else is at their
  /// corners.
  void give_up(const Workspace& w, const SolidData& a, const SolidData& b, const SlotsOfBoth& slots,
               const Faces& faces);

  bool empty() const { return count_ == 0; }
  /// Is a face deep?
  bool has(Operand s, std::uint32_t slot, FaceId local) const {
    return !empty() && state(s, slot, local) < at_rim;
  }
  /// Are all of a slot?
  bool has_all(Operand s, std::uint32_t slot) const {
    return !empty() && of_[s].others[slot] == none_is;
  }
  /// Of a deep face: do both run the same way around?
  Class class_of(Operand s, std::uint32_t slot, FaceId local) const {
    return static_cast<Class>(state(s, slot, local));
  }
  /// Has the other boundary no such face?
  bool differs(Operand s, std::uint32_t slot, FaceId local) const {
    return empty() || state(s, slot, local) == differing;
  }
  /// Is there such a face in a slot?
  bool any_differs(Operand s, std::uint32_t slot) const {
    return empty() || of_[s].others[slot] == some_differ;
  }

 private:
  friend class CommonFacesFinder;
  static constexpr std::uint32_t none = 0xFFFFFFFFu;
  // States of faces; below these: the class of one that is deep.
  static constexpr std::uint8_t at_rim = 0xFE, differing = 0xFF;
  // What there is in a slot beside deep faces.
  static constexpr std::uint8_t none_is = 0, some_at_rim = 1, some_differ = 2;

  struct OfSolid {
    std::vector<std::uint8_t> of_slot;  // per slot: of all its faces, unless they have their own
    std::vector<std::uint32_t> first;   // per slot: of its faces in the next, or none
    std::vector<std::uint8_t> of_face;
    std::vector<std::uint8_t> others;  // per slot
  };
  std::uint8_t state(Operand s, std::uint32_t slot, FaceId local) const {
    const OfSolid& of = of_[s];
    return of.first[slot] == none ? of.of_slot[slot] : of.of_face[of.first[slot] + local.value()];
  }

  PerOperand<OfSolid> of_;
  std::size_t count_ = 0;
};

}  // namespace sectile
