// Hubs (search/hubs.h) at which both solids have a fan: only directions tell which faces of two
// fans meet elsewhere.
#pragma once

#include <span>
#include <vector>

#include "boolean/reduction/reduction.h"
#include "boolean/workspace.h"

namespace sectile {

class CommonHubs {
 public:
  /// Of the blocks in some slots of each solid.
  CommonHubs(const SolidData& a, const SolidData& b,
             const PerOperand<std::span<const std::uint32_t>>& slots);

  bool empty() const { return order_.empty(); }
  /// Hubs of two blocks.
  bool are_at_one_place(std::uint32_t slot_of_a, std::uint32_t hub_of_a, std::uint32_t slot_of_b,
                        std::uint32_t hub_of_b) const {
    return place_[Operand::a][first_[Operand::a][slot_of_a] + hub_of_a] ==
           place_[Operand::b][first_[Operand::b][slot_of_b] + hub_of_b];
  }

  /// Adds the pairs that leave a common hub in a common direction.
  void add_pairs(FacePairs& pairs) const;
  /// The faces of all fans: they meet in their hubs. Some may be named twice.
  PerOperand<std::vector<FaceId>> faces() const;
  /// The hub itself meets every face of the other fan: adds the pairs of loaded faces in which that
  /// is tested. Of several vertices there one is tested for all (Patch::tested), but each where an
  /// edge passes through the hub: what meets in such a place is known by its own vertices.
  void add_pairs_of_owners(Workspace& w, FacePairs& pairs) const;

 private:
  struct Hub {
    Operand solid;
    std::uint32_t slot, number;
  };
  struct Fan {
    std::vector<FaceId> faces;
    std::vector<Box> directions;
  };

  const Block& block(Operand s, std::uint32_t slot) const { return *data_[s]->slot(slot).block; }
  const Block& block(const Hub& h) const { return block(h.solid, h.slot); }
  const Hubs& hubs(Operand s, std::uint32_t slot) const { return block(s, slot).tree().hubs(); }
  PointId point(const Hub& h) const { return hubs(h.solid, h.slot).point(h.number); }
  const Vec3& position(const Hub& h) const { return block(h).geometry().position(point(h)); }
  std::uint32_t& place_of(const Hub& h) {
    return place_[h.solid][first_[h.solid][h.slot] + h.number];
  }
  std::uint32_t place_of(const Hub& h) const {
    return place_[h.solid][first_[h.solid][h.slot] + h.number];
  }
  bool are_at_one_place(const Hub& g, const Hub& h) const;
  template <class Visit>
  void for_each_place(const Visit& visit) const;

  PerOperand<const SolidData*> data_;
  std::vector<Hub> order_;                        // by place
  PerOperand<std::vector<std::uint32_t>> first_;  // per slot: its first hub
  PerOperand<std::vector<std::uint32_t>> place_;  // per hub
};

}  // namespace sectile
