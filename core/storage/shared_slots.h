// The slots that a new solid takes from others, and what changes in how they are linked.
#pragma once

#include <utility>
#include <vector>

#include "parallel/parallel.h"
#include "sectile/errors.h"
#include "storage/solid_data.h"

namespace sectile {

struct SharedSlots {
  SharedSlots() = default;
  explicit SharedSlots(std::vector<Slot> taken) : slots(std::move(taken)) {}

  std::vector<Slot> slots;  ///< some of them empty

  /// The links that a slot will have, to be changed: at first those that it has.
  std::vector<BorderLink>& links_of(std::uint32_t slot) {
    change_.resize(slots.size(), none);
    if (change_[slot] == none) {
      change_[slot] = static_cast<std::uint32_t>(changes_.size());
      changes_.push_back({slot, {}});
      if (slots[slot].links) changes_.back().links = slots[slot].links->all();
    }
    return changes_[change_[slot]].links;
  }

  /// The slots are linked so.
  void relink() {
    parallel::loop(parallel::Range<std::size_t>(0, changes_.size(), 16), [&](const auto& range) {
      for (std::size_t i = range.begin(); i < range.end(); ++i) relink(changes_[i]);
    });
    changes_.clear();
    change_.clear();
  }

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;
  struct Change {
    std::uint32_t slot;
    std::vector<BorderLink> links;
  };

  void relink(Change& change) {
    for (const BorderLink& link : change.links)
      if (link.border == none) throw InternalError("a border of a block leads nowhere");
    Slot& slot = slots[change.slot];
    slot.links = change.links.empty()
                     ? nullptr
                     : std::make_shared<const BorderLinks>(std::move(change.links));
  }

  std::vector<std::uint32_t> change_;  // per slot: its change, or none
  std::vector<Change> changes_;
};

}  // namespace sectile
