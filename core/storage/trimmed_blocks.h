// Blocks of which some faces are taken away: what is left of each is a block of its own, in the
// slot of the old one.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "storage/block_of_faces.h"
#include "storage/cut_into_blocks.h"
#include "storage/shared_slots.h"

namespace sectile {

/// What is left of a block.
class TrimmedBlock {
 public:
  /// `faces`: those that stay.
  TrimmedBlock(const Block& old, std::vector<FaceId> faces);

  const std::shared_ptr<Block>& block() const { return made_.block(); }
  /// Per border edge: which it was in the old block.
  const std::vector<HalfEdgeId>& borders() const { return made_.leaving(); }
  /// The border edge that was this half-edge of the old block; none if its face is gone.
  static constexpr std::uint32_t none = 0xFFFFFFFFu;
  std::uint32_t border_at(HalfEdgeId old) const {
    return local_[old.value()].valid() ? local_[old.value()].value() / 2 : none;
  }

 private:
  std::vector<FaceId> faces_;
  std::vector<HalfEdgeId> local_;  // per half-edge of the old block
  BlockOfFaces made_;
};

/// Those of one solid.
class TrimmedBlocks {
 public:
  explicit TrimmedBlocks(const SolidData& solid) : solid_(solid), trimmed_(solid.slots().size()) {}

  /// `faces`: per slot, those that stay; the others' blocks stay or go as they are.
  struct Rest {
    std::uint32_t slot;
    std::vector<FaceId> faces;
  };
  void trim(std::vector<Rest> rests);

  std::span<const std::uint32_t> slots() const { return slots_; }
  const TrimmedBlock* operator[](std::uint32_t slot) const { return trimmed_[slot].get(); }

  /// The border edge at a half-edge of a slot that stays or is trimmed; it is no longer one of the
  /// solid's if its number is TrimmedBlock::none.
  BorderEdge border_edge(std::uint32_t slot, HalfEdgeId in_old_block) const;

  /// Links the blocks to each other and to their neighbours that stay. `first`: where the solid's
  /// slots begin. The links to what goes have no meaning yet.
  void link(SharedSlots& shared, std::uint32_t first) const;

 private:
  BorderLink followed(std::uint32_t slot, const BorderLink& link) const;

  const SolidData& solid_;
  std::vector<std::unique_ptr<const TrimmedBlock>> trimmed_;  // per slot
  std::vector<std::uint32_t> slots_;                          // those trimmed
};

}  // namespace sectile
