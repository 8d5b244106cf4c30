// What is left of blocks of which faces are loaded: faces that hang together over edges of the
// block, not over what is loaded, are a piece.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boolean/patch.h"

namespace sectile {

class LeftPieces {
 public:
  LeftPieces() = default;
  explicit LeftPieces(const Patch& patch);

  /// Are faces of the slot's block loaded? What follows is only of such slots.
  bool is_touched(std::uint32_t slot) const { return number_[slot] != none; }
  std::uint32_t count(std::uint32_t slot) const {
    return static_cast<std::uint32_t>(slots_[number_[slot]].first_end.size() - 1);
  }

  static constexpr std::uint32_t loaded = 0xFFFFFFFEu;
  /// The piece of a face of the block, or `loaded`.
  std::uint32_t of(std::uint32_t slot, FaceId local) const {
    return slots_[number_[slot]].piece[local.value()];
  }
  /// Some face of a piece.
  FaceId face_of(std::uint32_t slot, std::uint32_t piece) const;
  /// Half-edges of a piece's faces beyond which all that is beside it lies: faces that are loaded,
  /// and other blocks.
  std::span<const HalfEdgeId> ends(std::uint32_t slot, std::uint32_t piece) const {
    const OfSlot& of = slots_[number_[slot]];
    return std::span(of.ends).subspan(of.first_end[piece],
                                      of.first_end[piece + 1] - of.first_end[piece]);
  }

 private:
  struct OfSlot {
    std::uint32_t slot;
    std::vector<std::uint32_t> piece;            // per face
    std::vector<HalfEdgeId> ends = {};           // by piece
    std::vector<std::uint32_t> first_end = {0};  // per piece, and the end
  };
  static constexpr std::uint32_t none = 0xFFFFFFFFu;

  void find_pieces(OfSlot& of) const;
  void follow(OfSlot& of, FaceId start, std::vector<FaceId>& faces) const;

  const SolidData* solid_ = nullptr;
  std::vector<std::uint32_t> number_;  // per slot: index of the following, or `none`
  std::vector<OfSlot> slots_;
};

}  // namespace sectile
