// Labels for what is not loaded of an operand: for each piece of a block, or of what is left of one
// of which faces are loaded. What is in one region has one label together, and is not looked at.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boolean/components/clear_regions.h"
#include "boolean/components/left_pieces.h"

namespace sectile {

class RestLabels {
 public:
  RestLabels() = default;
  /// All unknown; nothing is left of a patch that is the whole solid.
  explicit RestLabels(const Patch& patch);

  static constexpr std::uint8_t unknown = 255, loaded = 254;
  static constexpr std::uint32_t none = ClearRegions::none;

  /// All in one region, but for slots of which faces are loaded, has one label.
  void set_regions(ClearRegions regions);
  /// Of a slot, or none.
  std::uint32_t region(std::uint32_t slot) const { return region_[slot]; }
  std::uint32_t region_count() const { return static_cast<std::uint32_t>(region_label_.size()); }
  std::uint8_t& of_region(std::uint32_t region) { return region_label_[region]; }

  /// Are there faces that are not loaded?
  bool empty() const { return solid_ == nullptr; }
  /// Of the slots of which faces are loaded.
  const LeftPieces& left() const { return left_; }
  bool is_touched(std::uint32_t slot) const { return left_.is_touched(slot); }
  bool is_loaded(std::uint32_t slot, FaceId local) const {
    return is_touched(slot) && left_.of(slot, local) == LeftPieces::loaded;
  }

  /// How many pieces of a slot have labels of their own.
  std::uint32_t count(std::uint32_t slot) const {
    return is_touched(slot) ? left_.count(slot) : solid_->slot(slot).pieces;
  }
  /// Of a face that is not loaded.
  std::uint32_t piece(std::uint32_t slot, FaceId local) const {
    return is_touched(slot) ? left_.of(slot, local) : solid_->slot(slot).block->pieces().of(local);
  }
  /// Of a slot in no region. Valid until the next call.
  std::uint8_t& of_piece(std::uint32_t slot, std::uint32_t piece) {
    if (first_[slot] == none) add_pieces(slot);
    return labels_[first_[slot] + piece];
  }
  std::uint8_t label_of_piece(std::uint32_t slot, std::uint32_t piece) const {
    if (region_[slot] != none) return region_label_[region_[slot]];
    return first_[slot] == none ? unknown : labels_[first_[slot] + piece];
  }
  /// The label of a face that is not loaded; `loaded` of others.
  std::uint8_t label(std::uint32_t slot, FaceId local) const {
    if (region_[slot] != none) return region_label_[region_[slot]];
    if (is_loaded(slot, local)) return loaded;
    return first_[slot] == none ? unknown : labels_[first_[slot] + piece(slot, local)];
  }
  /// Has a piece of the slot this label, or have all?
  bool has(std::uint32_t slot, std::uint8_t label) const;
  bool has_only(std::uint32_t slot, std::uint8_t label) const;

 private:
  void add_pieces(std::uint32_t slot);
  std::span<const std::uint8_t> labels(std::uint32_t slot) const;

  const SolidData* solid_ = nullptr;
  LeftPieces left_;
  std::vector<std::uint32_t> region_;  // per slot, or none
  std::vector<std::uint8_t> region_label_;
  std::vector<std::uint32_t> first_;  // per slot: of its labels; none as long as all are unknown
  std::vector<std::uint8_t> labels_;
};

}  // namespace sectile
