// Hubs (search/hubs.h) at which both solids have a fan: only directions tell which faces of two
// fans meet elsewhere. Hubs on a line along which many edges run have one fan in common, whose
// faces are told apart by the directions in which they leave the line.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "boolean/near/common_faces.h"
#include "boolean/near/common_fan.h"
#include "search/spine_lines.h"
#include "storage/solid_data.h"

namespace sectile {

class CommonHubs {
 public:
  /// Of the blocks in some slots of each solid, without the faces in `left_out`.
  CommonHubs(const SolidData& a, const SolidData& b,
             const PerOperand<std::span<const std::uint32_t>>& slots, const CommonFaces& left_out);

  bool empty() const { return order_.empty(); }
  /// The number of the fan of a block's hub.
  std::uint32_t fan(Operand s, std::uint32_t slot, std::uint32_t hub) const {
    return fan_[s][first_[s][slot] + hub];
  }
  /// Hubs of two blocks.
  bool are_of_one_fan(std::uint32_t slot_of_a, std::uint32_t hub_of_a, std::uint32_t slot_of_b,
                      std::uint32_t hub_of_b) const {
    return fan(Operand::a, slot_of_a, hub_of_a) == fan(Operand::b, slot_of_b, hub_of_b);
  }

  /// Adds the pairs that leave a common hub, or line, in a common direction. False: there are more
  /// than `most` of all pairs, and not all were added.
  bool add_pairs(FacePairs& pairs,
                 std::size_t most = std::numeric_limits<std::size_t>::max()) const;
  /// The faces of all fans: they meet in their hubs. Some may be named twice.
  PerOperand<std::vector<FaceId>> faces() const;
  /// Those of fans on lines that are left out. What has an edge on such a line may touch them
  /// there, and is in no pair with them.
  CommonFaces::Faces left_out_on_lines() const;
  /// The hubs themselves, and edges between them, meet the faces of the other fan: adds the pairs
  /// of loaded faces in which that is tested, of what is in one place for all (Patch::tested).
  void add_pairs_of_owners(Workspace& w, FacePairs& pairs) const;

 private:
  struct Hub {
    Operand solid;
    std::uint32_t slot, number;
  };

  const Block& block(Operand s, std::uint32_t slot) const { return *data_[s]->slot(slot).block; }
  const Block& block(const Hub& h) const { return block(h.solid, h.slot); }
  const Hubs& hubs(Operand s, std::uint32_t slot) const { return block(s, slot).tree().hubs(); }
  PointId point(const Hub& h) const { return hubs(h.solid, h.slot).point(h.number); }
  const Vec3& position(const Hub& h) const { return block(h).geometry().position(point(h)); }
  std::uint32_t& fan_of(const Hub& h) { return fan_[h.solid][first_[h.solid][h.slot] + h.number]; }
  std::uint32_t fan_of(const Hub& h) const { return fan(h.solid, h.slot, h.number); }
  bool are_at_one_place(const Hub& g, const Hub& h) const;
  void number_places();
  void find_lines();
  std::vector<Hubs::Spine> spines_between_places() const;
  std::vector<Box> boxes_along_line(const Hub& h, std::uint32_t fan) const;
  void add_faces(const Hub& h, std::uint32_t fan, Fan& to) const;
  template <class Visit>
  void for_each_fan(const Visit& visit) const;

  PerOperand<const SolidData*> data_;
  const CommonFaces& left_out_;
  std::vector<Hub> order_;                        // by fan
  PerOperand<std::vector<std::uint32_t>> first_;  // per slot: its first hub
  // Per hub: its place, or, behind all places, its line.
  PerOperand<std::vector<std::uint32_t>> fan_;
  SpineLines lines_;
};

}  // namespace sectile
