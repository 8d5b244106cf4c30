#include "storage/solid_data.h"

#include "sectile/errors.h"
#include "storage/cut_into_blocks.h"
#include "storage/join_blocks.h"
#include "storage/splice.h"
#include "storage/touching_slots.h"

namespace sectile {

SolidData::SolidData() : making_(std::make_shared<Block>()) {
  slots_.push_back({making_, nullptr});
  base_ = page_slot_ = {0};
}

SolidData::SolidData(std::vector<Slot> slots, bool touches_itself)
    : slots_(std::move(slots)), may_touch_itself_(touches_itself) {
  number_pages();
}

void SolidData::cut() {
  if (brep().face_count() > most_faces_of_a_block) {
    may_touch_itself_ = touches_itself();
    slots_ = cut_into_blocks({making_->brep(), making_->geometry(), {}, Places{}}).slots;
  }
  making_.reset();
  number_pages();
}

namespace {

void count_elements(Slot& slot) {
  slot.faces = static_cast<std::uint32_t>(slot.block->face_count());
  slot.half_edges = static_cast<std::uint32_t>(slot.block->half_edge_count());
  slot.pieces = slot.block->pieces().count();
}

}  // namespace

void SolidData::number_pages() {
  base_.clear();
  page_slot_.clear();
  face_count_ = 0;
  const bool several = slots_.size() > 1;
  base_.reserve(slots_.size());
  page_slot_.reserve(slots_.size());
  for (std::uint32_t s = 0; s < slots_.size(); ++s) {
    Slot& slot = slots_[s];
    base_.push_back(static_cast<std::uint32_t>(page_slot_.size() << page_bits));
    if (slot.empty()) continue;
    if (slot.half_edges == 0) count_elements(slot);
    if (several && slot.touching == Slot::Touching::unknown)
      slot.touching = slot.may_touch() ? Slot::Touching::yes : Slot::Touching::no;
    face_count_ += slot.faces;
    page_slot_.resize(page_slot_.size() + (slot.half_edges >> page_bits) + 1, s);
  }
  if (page_slot_.size() >= std::size_t(1) << (30 - page_bits))
    throw Error("the solid has more half-edges than can be numbered");
}

const Block& SolidData::whole() const {
  if (is_whole()) return *slots_[0].block;
  once_alone(whole_once_, [this] {
    auto joined = std::make_shared<Block>();
    join_blocks(*this, joined->brep(), joined->geometry());
    joined_ = std::move(joined);
  });
  return *joined_;
}

const SolidData& SolidData::in_one_block() const {
  if (is_whole()) return *this;
  once_alone(one_block_once_, [this] {
    whole();
    auto made =
        std::make_shared<SolidData>(std::vector<Slot>{{joined_, nullptr}}, touches_itself());
    made->origin = origin;
    in_one_block_ = std::move(made);
  });
  return *in_one_block_;
}

const BoxTree& SolidData::slot_tree() const {
  once_alone(tree_once_, [this] {
    std::vector<Box> boxes;
    for (std::uint32_t s = 0; s < slots_.size(); ++s) {
      if (slots_[s].faces == 0) continue;
      slots_in_tree_.push_back(s);
      boxes.push_back(slots_[s].block->bounds());
    }
    slot_tree_ = BoxTree(boxes);
  });
  return slot_tree_;
}

bool SolidData::touches_itself() const {
  if (!may_touch_itself_) return false;
  if (!making_ && !is_whole()) return true;
  once_alone(touches_once_, [this] {
    touches_itself_ = vertices_coincide(slots_[0].block->brep(), slots_[0].block->geometry());
  });
  return touches_itself_;
}

std::span<const std::uint32_t> SolidData::touching_slots() const {
  once_alone(touching_slots_once_, [this] { touching_slots_ = find_touching_slots(*this); });
  return touching_slots_;
}

}  // namespace sectile
