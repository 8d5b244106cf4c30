// Pairs of faces of two solids that may meet, where faces lie in holes and bends of others: as
// rings in rings do, whose boxes all overlap.
#pragma once

#include <optional>

#include "boolean/near/common_hubs.h"
#include "boolean/reduction/reduction.h"
#include "boolean/workspace.h"
#include "search/face_pieces.h"

namespace sectile {

class NestedFaces {
 public:
  /// In some slots of each solid.
  NestedFaces(const Workspace& w, const SolidData& a, const SolidData& b, const SlotsOfBoth& slots);

  /// Those that leave much of their boxes empty, and the corners of all of them.
  std::size_t hollow_faces() const { return hollow_faces_; }
  std::size_t hollow_corners() const { return hollow_corners_; }

  /// But for those of faces that have a common hub. Some are found several times. None if pieces of
  /// faces are hardly less near each other than the faces are.
  std::optional<FacePairs> pairs(const CommonHubs& hubs) const;

 private:
  // All faces of a slot have numbers one after another, those of A first.
  struct Place {
    Operand solid;
    std::uint32_t slot, first;
    std::vector<FaceId> hollow;
  };

  void find_hollow_faces(Place& place);
  FacePieces pieces() const;
  void add_pieces(const Place& place, FacePieces& to) const;
  std::vector<std::uint32_t> labels(const CommonHubs& hubs) const;
  std::vector<FaceId> faces_in_solids() const;
  const Block& block(const Place& p) const { return *data_[p.solid]->slot(p.slot).block; }

  const Workspace& w_;
  PerOperand<const SolidData*> data_;
  std::vector<Place> places_;
  std::uint32_t first_of_b_ = 0, face_count_ = 0;
  std::size_t hollow_faces_ = 0, hollow_corners_ = 0;
};

}  // namespace sectile
