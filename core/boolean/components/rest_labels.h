// Labels for what is not loaded of an operand: for each face in blocks of which faces are loaded,
// and for each piece of the others.
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

  static constexpr std::uint8_t unknown = 255;

  /// Are there faces that are not loaded?
  bool empty() const { return labels_.empty(); }
  /// Are faces of the slot's block loaded?
  bool is_touched(std::uint32_t slot) const { return touched_[slot] != 0; }
  bool is_loaded(std::uint32_t slot, FaceId local) const {
    return is_touched(slot) && label(slot, local) == loaded;
  }

  /// How many faces or pieces of a slot have labels of their own; they are numbered.
  std::uint32_t count(std::uint32_t slot) const { return first_[slot + 1] - first_[slot]; }
  std::uint32_t member(std::uint32_t slot, FaceId local) const {
    return is_touched(slot) ? local.value()
                            : solid_->slot(slot).block->pieces().of_face[local.value()];
  }
  std::uint8_t& of_member(std::uint32_t slot, std::uint32_t member) {
    return labels_[first_[slot] + member];
  }
  std::uint8_t of_member(std::uint32_t slot, std::uint32_t member) const {
    return labels_[first_[slot] + member];
  }
  /// The label of a face that is not loaded; `loaded` of others.
  std::uint8_t label(std::uint32_t slot, FaceId local) const {
    return of_member(slot, member(slot, local));
  }
  static constexpr std::uint8_t loaded = 254;

 private:
  const SolidData* solid_ = nullptr;
  std::vector<std::uint8_t> touched_, labels_;
  std::vector<std::uint32_t> first_;  // per slot
};

}  // namespace sectile
