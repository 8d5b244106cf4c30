// What a Solid holds: slots with blocks, which it may share with other solids.
//
// Elements have numbers in the whole solid: those within the block plus a base of the slot. All
// numbers of a slot lie on pages of its own, so that a number leads to its slot. In a solid of one
// block they are the block's.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "parallel/once_alone.h"
#include "storage/block.h"
#include "storage/border_links.h"

namespace sectile {

struct FacesAsRead;

struct Slot {
  std::shared_ptr<const Block> block;  ///< none if the slot is empty
  std::shared_ptr<const BorderLinks>
      links;            ///< per border edge of the block; none if there is none
  bool turned = false;  ///< all half-edges run the other way: the material is on the other side
  /// Of the block, once the slot is in a solid: not to go to each block for them.
  std::uint32_t faces = 0, half_edges = 0, pieces = 0;
  enum class Touching : std::uint8_t { unknown, no, yes } touching = Touching::unknown;

  bool empty() const { return !block; }
  /// Does the solid touch itself at vertices of the block, or did it?
  bool may_touch() const {
    return !empty() && (touching == Touching::unknown ? !block->touching_vertices().empty()
                                                      : touching == Touching::yes);
  }
  // Half-edges as they run in the solid.
  HalfEdgeId next_of(HalfEdgeId h) const {
    return turned ? block->brep().prev_of(h) : block->brep().next_of(h);
  }
  VertexId from(HalfEdgeId h) const { return turned ? block->brep().to(h) : block->brep().from(h); }
  VertexId to(HalfEdgeId h) const { return turned ? block->brep().from(h) : block->brep().to(h); }
  PointId start_of(HalfEdgeId h) const { return block->brep().point_of(from(h)); }
};

/// Calls visit(HalfEdgeId) for every half-edge of a loop of the slot's block, as they run in the
/// solid.
template <class Visit>
void for_each_in_loop(const Slot& slot, LoopId loop, Visit&& visit) {
  const HalfEdgeId first = slot.block->brep().loop_half_edge[loop];
  HalfEdgeId h = first;
  do {
    visit(h);
    h = slot.next_of(h);
  } while (h != first);
}

class SolidData {
 public:
  /// One block, to be filled through brep() and geometry() before anyone else sees it.
  SolidData();
  /// `touches_itself`: several of its vertices may be at one point.
  SolidData(std::vector<Slot> slots, bool touches_itself);

  Brep& brep() { return making_->brep(); }
  Geometry& geometry() { return making_->geometry(); }
  /// Ends the filling: a large boundary is cut into blocks.
  void cut();

  std::uint32_t origin = 0;  ///< see Solid::origin
  /// Of an import whose coplanar faces were joined, and which nothing has changed since.
  std::shared_ptr<const FacesAsRead> as_read;

  // The boundary as one structure. If it is in several blocks, they are joined when this is first
  // asked for: for work on all of the boundary.
  const Brep& brep() const { return whole().brep(); }
  const Geometry& geometry() const { return whole().geometry(); }
  const FaceTree& tree() const { return whole().tree(); }
  const Block& whole() const;
  const SolidData& in_one_block() const;

  // The boundary in blocks.
  /// Is it in one block, with the same numbers?
  bool is_whole() const {
    return slots_.size() == 1 && !slots_[0].turned && slots_[0].block->border_count == 0;
  }
  std::span<const Slot> slots() const { return slots_; }
  const Slot& slot(std::uint32_t s) const { return slots_[s]; }
  std::uint32_t base(std::uint32_t slot) const { return base_[slot]; }
  std::uint32_t slot_of(FaceId f) const { return slot_at(f.value()); }
  std::uint32_t slot_of(HalfEdgeId h) const { return slot_at(h.value()); }
  FaceId face(std::uint32_t slot, FaceId local) const {
    return FaceId(base_[slot] + local.value());
  }
  HalfEdgeId half_edge(std::uint32_t slot, HalfEdgeId local) const {
    return HalfEdgeId(base_[slot] + local.value());
  }
  FaceId local(std::uint32_t slot, FaceId f) const { return FaceId(f.value() - base_[slot]); }
  HalfEdgeId local(std::uint32_t slot, HalfEdgeId h) const {
    return HalfEdgeId(h.value() - base_[slot]);
  }
  /// The half-edge on the other side of an edge. Edges between blocks have one half-edge of each.
  struct Neighbour {
    std::uint32_t slot;
    HalfEdgeId local;
  };
  Neighbour across(std::uint32_t slot, HalfEdgeId local) const {
    const Slot& s = slots_[slot];
    if (!s.block->is_border(local)) return {slot, Brep::twin(local)};
    const BorderLink& link = s.links->all()[local.value() / 2];
    return {slot + static_cast<std::uint32_t>(link.slots), HalfEdgeId(2 * link.border)};
  }
  std::size_t face_count() const { return making_ ? making_->brep().face_count() : face_count_; }
  bool empty() const { return face_count() == 0; }

  /// A hierarchy over the slots that are not empty; its items are indices in `slots_in_tree`.
  const BoxTree& slot_tree() const;
  std::span<const std::uint32_t> slots_in_tree() const { return slots_in_tree_; }

  /// May several of its vertices be at one point? Found out when first asked.
  bool touches_itself() const;
  /// Where it touches itself (storage/touching_slots.h). Found out when first asked.
  std::span<const std::uint32_t> touching_slots() const;

  /// What make() gives when this is called first, and then kept: the same boundary with its edges
  /// paired for the complement (boolean/complement.h), or none if that is this one.
  template <class Make>
  const SolidData* complement(const Make& make) const {
    once_alone(complement_once_, [&] { complement_ = make(); });
    return complement_.get();
  }

 private:
  static constexpr unsigned page_bits = 10;
  std::uint32_t slot_at(std::uint32_t number) const { return page_slot_[number >> page_bits]; }
  void number_pages();

  std::vector<Slot> slots_;
  std::vector<std::uint32_t> base_, page_slot_;
  std::size_t face_count_ = 0;
  std::shared_ptr<Block> making_;
  bool may_touch_itself_ = true;

  mutable OnceFlag whole_once_, one_block_once_, tree_once_, touches_once_, touching_slots_once_,
      complement_once_;
  mutable std::shared_ptr<const Block> joined_;
  mutable std::shared_ptr<const SolidData> in_one_block_;
  mutable BoxTree slot_tree_;
  mutable std::vector<std::uint32_t> slots_in_tree_;
  mutable bool touches_itself_ = false;
  mutable std::vector<std::uint32_t> touching_slots_;
  mutable std::shared_ptr<const SolidData> complement_;
};

}  // namespace sectile
