// Labels for what is not loaded of an operand: for each face in blocks of which faces are loaded,
// and for each piece of the others. Blocks that no label reaches are not looked at.
#pragma once

#include <cstdint>
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
    return is_touched(slot) ? local.value()
                            : solid_->slot(slot).block->pieces().of_face[local.value()];
  }
  /// Valid until the next call.
  std::uint8_t& of_member(std::uint32_t slot, std::uint32_t member) {
    if (first_[slot] == none) add_members(slot);
    return labels_[first_[slot] + member];
  }
  /// The label of a face that is not loaded; `loaded` of others.
  std::uint8_t label(std::uint32_t slot, FaceId local) const {
    return first_[slot] == none ? others_ : labels_[first_[slot] + member(slot, local)];
  }
  /// Is there a face with this label in the slot, or are there only such?
  bool has(std::uint32_t slot, std::uint8_t label) const;
  bool has_only(std::uint32_t slot, std::uint8_t label) const;

  /// Labels all that are unknown.
  void label_others(std::uint8_t label);

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;
  void add_members(std::uint32_t slot);
  std::span<const std::uint8_t> labels(std::uint32_t slot) const;

  const SolidData* solid_ = nullptr;
  std::vector<std::uint8_t> touched_;  // per slot
  std::vector<std::uint32_t> first_;   // per slot: of its labels; none if all are `others_`
  std::vector<std::uint8_t> labels_;
  std::uint8_t others_ = unknown;
};

}  // namespace sectile
