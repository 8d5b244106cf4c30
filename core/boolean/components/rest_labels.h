// Labels for what is not loaded of an operand: for each face in blocks of which faces are loaded,
// and for each piece of the others. Those that are far have one label together, and are not looked
// at.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boolean/patch.h"

namespace sectile {

class RestLabels {
 public:
  RestLabels() = default;
  /// All unknown; nothing is left of a patch that is the whole solid.
  explicit RestLabels(const Patch& patch);

  static constexpr std::uint8_t unknown = 255, loaded = 254;

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
  /// Valid until the next call; of what is far, not to be changed.
  std::uint8_t& of_member(std::uint32_t slot, std::uint32_t member) {
    if (is_far(slot)) return far_label_;
    if (first_[slot] == none) add_members(slot);
    return labels_[first_[slot] + member];
  }
  /// Per face of a touched slot. Valid until of_member() is called.
  std::span<std::uint8_t> of_touched(std::uint32_t slot) {
    return std::span(labels_).subspan(first_[slot], count(slot));
  }
  /// The label of a face that is not loaded; `loaded` of others.
  std::uint8_t label(std::uint32_t slot, FaceId local) const {
    return first_[slot] == none ? far_label_ : labels_[first_[slot] + member(slot, local)];
  }
  /// Is there a face with this label in the slot, or are there only such?
  bool has(std::uint32_t slot, std::uint8_t label) const;
  bool has_only(std::uint32_t slot, std::uint8_t label) const;

  /// All slots but those that are near or touched are far, with this label.
  void label_all_but(std::span<const std::uint32_t> near, std::uint8_t label);
  bool is_far(std::uint32_t slot) const { return first_[slot] == none && far_label_ != unknown; }
  std::uint8_t far_label() const { return far_label_; }

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;
  void add_members(std::uint32_t slot);
  std::span<const std::uint8_t> labels(std::uint32_t slot) const;

  const SolidData* solid_ = nullptr;
  std::vector<std::uint8_t> touched_;  // per slot
  std::vector<std::uint32_t> first_;   // per slot: of its labels; none if it has none of its own
  std::vector<std::uint8_t> labels_;
  std::uint8_t far_label_ = unknown;  // unknown if nothing is far
};

}  // namespace sectile
