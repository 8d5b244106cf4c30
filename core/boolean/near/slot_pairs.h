// The slots of two solids whose blocks may meet.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "boolean/near/common_faces.h"
#include "boolean/operand.h"
#include "search/box_tree.h"
#include "storage/solid_data.h"

namespace sectile {

class SlotPairs {
 public:
  SlotPairs(const SolidData& a, const SolidData& b) {
    BoxTree::overlaps(a.slot_tree(), b.slot_tree(), [&](std::uint32_t i, std::uint32_t j) {
      pairs_.push_back({a.slots_in_tree()[i], b.slots_in_tree()[j]});
    });
    collect_slots();
  }
  /// Of some slots of one solid, which are ascending.
  SlotPairs(const SolidData& solid, std::span<const std::uint32_t> slots) {
    std::vector<Box> boxes;
    for (const std::uint32_t s : slots) boxes.push_back(solid.slot(s).block->bounds());
    const BoxTree tree(boxes);
    BoxTree::overlaps(tree, tree, [&](std::uint32_t i, std::uint32_t j) {
      pairs_.push_back({slots[i], slots[j]});
    });
    collect_slots();
  }
  std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs() const { return pairs_; }
  std::span<const std::uint32_t> slots(Operand s) const { return slots_[s]; }
  SlotsOfBoth slots() const { return {{slots(Operand::a), slots(Operand::b)}}; }

  std::size_t count_faces(const SolidData& a, const SolidData& b) const {
    std::size_t count = 0;
    for (const std::uint32_t s : slots(Operand::a)) count += a.slot(s).faces;
    for (const std::uint32_t t : slots(Operand::b)) count += b.slot(t).faces;
    return count;
  }

  /// Those of two slots with the same block.
  bool have_common_blocks(const SolidData& a, const SolidData& b) const {
    return std::ranges::any_of(pairs_, [&](const auto& pair) {
      return a.slot(pair.first).block == b.slot(pair.second).block;
    });
  }
  /// Without those of which one has deep faces only, and the other one only common faces.
  SlotPairs without(const CommonFaces& faces) const {
    const auto is_left_out = [&](std::uint32_t i, std::uint32_t j) {
      return (faces.has_all(Operand::a, i) && !faces.any_differs(Operand::b, j)) ||
             (faces.has_all(Operand::b, j) && !faces.any_differs(Operand::a, i));
    };
    SlotPairs left;
    for (const auto& [i, j] : pairs_)
      if (!is_left_out(i, j)) left.pairs_.push_back({i, j});
    left.collect_slots();
    return left;
  }

 private:
  SlotPairs() = default;
  void collect_slots() {
    std::sort(pairs_.begin(), pairs_.end());
    for (const auto& [i, j] : pairs_) {
      if (slots_[Operand::a].empty() || slots_[Operand::a].back() != i)
        slots_[Operand::a].push_back(i);
      slots_[Operand::b].push_back(j);
    }
    std::vector<std::uint32_t>& of_b = slots_[Operand::b];
    std::sort(of_b.begin(), of_b.end());
    of_b.erase(std::unique(of_b.begin(), of_b.end()), of_b.end());
  }

  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_;
  PerOperand<std::vector<std::uint32_t>> slots_;
};

}  // namespace sectile
