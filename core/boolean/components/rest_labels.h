// Labels for what is not loaded of an operand: for each face in blocks of which faces are loaded,
// and for each piece of the others. What is in one region has one label together, and is not
// looked at.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boolean/components/clear_regions.h"
#include "boolean/patch.h"

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
  /// Are faces of the slot's block loaded?
  bool is_touched(std::uint32_t slot) const { return touched_[slot] != 0; }
  bool is_loaded(std::uint32_t slot, FaceId local) const {
    return is_touched(slot) && label(slot, local) == loaded;
  }

  /// How many faces or pieces of a slot have labels of their own; they are numbered.
  std::uint32_t count(std::uint32_t slot) const;
  std::uint32_t member(std::uint32_t slot, FaceId local) const {
    return is_touched(slot) ? local.value() : solid_->slot(slot).block->pieces().of(local);
  }
  /// Of a slot in no region. Valid until the next call.
  std::uint8_t& of_member(std::uint32_t slot, std::uint32_t member) {
    if (first_[slot] == none) add_members(slot);
    return labels_[first_[slot] + member];
  }
  std::uint8_t label_of_member(std::uint32_t slot, std::uint32_t member) const {
    if (region_[slot] != none) return region_label_[region_[slot]];
    return first_[slot] == none ? unknown : labels_[first_[slot] + member];
  }
  /// Per face of a touched slot. Valid until of_member() is called.
  std::span<std::uint8_t> of_touched(std::uint32_t slot) {
    return std::span(labels_).subspan(first_[slot], count(slot));
  }
  /// The label of a face that is not loaded; `loaded` of others.
  std::uint8_t label(std::uint32_t slot, FaceId local) const {
    if (region_[slot] != none) return region_label_[region_[slot]];
    return first_[slot] == none ? unknown : labels_[first_[slot] + member(slot, local)];
  }
  /// Is there a face with this label in the slot, or are there only such?
  bool has(std::uint32_t slot, std::uint8_t label) const;
  bool has_only(std::uint32_t slot, std::uint8_t label) const;

 private:
  void add_members(std::uint32_t slot);
  std::span<const std::uint8_t> labels(std::uint32_t slot) const;

  const SolidData* solid_ = nullptr;
  std::vector<std::uint8_t> touched_;  // per slot
  std::vector<std::uint32_t> region_;  // per slot, or none
  std::vector<std::uint8_t> region_label_;
  std::vector<std::uint32_t> first_;  // per slot: of its labels; none as long as all are unknown
  std::vector<std::uint8_t> labels_;
};

}  // namespace sectile
