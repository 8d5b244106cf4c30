#include "boolean/components/left_pieces.h"

#include <algorithm>

#include "numbers/threshold.h"
#include "parallel/parallel.h"

namespace sectile {

LeftPieces::LeftPieces(const Patch& patch)
    : solid_(patch.solid), number_(patch.solid->slots().size(), none) {
  for (const FaceId f : patch.face_in_solid) {
    const std::uint32_t s = solid_->slot_of(f);
    if (number_[s] == none) {
      number_[s] = static_cast<std::uint32_t>(slots_.size());
      slots_.push_back({s, std::vector(solid_->slot(s).faces, none)});
    }
    slots_[number_[s]].piece[solid_->local(s, f).value()] = loaded;
  }
  constexpr std::size_t few = threshold(4, 1);
  parallel::loop(parallel::Range<std::size_t>(0, slots_.size(), few), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) find_pieces(slots_[i]);
  });
}

void LeftPieces::find_pieces(OfSlot& of) const {
  std::vector<FaceId> faces;
  for (std::size_t f = 0; f < of.piece.size(); ++f) {
    if (of.piece[f] != none) continue;
    follow(of, FaceId(f), faces);
    of.first_end.push_back(static_cast<std::uint32_t>(of.ends.size()));
  }
}

// One piece. As a rule its borders lead to few other blocks, of which pieces are known that are not
// touched: of borders to the same one that follow each other, one will do.
void LeftPieces::follow(OfSlot& of, FaceId start, std::vector<FaceId>& faces) const {
  const Slot& slot = solid_->slot(of.slot);
  const Block& block = *slot.block;
  const auto piece = static_cast<std::uint32_t>(of.first_end.size() - 1);
  BorderLink known;  // at first the slot itself, to which no border leads
  const auto add_border = [&](HalfEdgeId h) {
    const BorderLink& link = slot.links->all()[Brep::edge_of(h).value()];
    if (link.slots == known.slots && link.piece == known.piece) return;
    of.ends.push_back(h);
    if (!is_touched(of.slot + static_cast<std::uint32_t>(link.slots))) known = link;
  };
  of.piece[start.value()] = piece;
  faces.assign(1, start);
  while (!faces.empty()) {
    const FaceId next = faces.back();
    faces.pop_back();
    for_each_in_face(block.brep(), next, [&](HalfEdgeId h) {
      if (block.is_border(h)) return add_border(h);
      const FaceId beyond = block.brep().face_of(Brep::twin(h));
      std::uint32_t& there = of.piece[beyond.value()];
      if (there == loaded) of.ends.push_back(h);
      if (there != none) return;
      there = piece;
      faces.push_back(beyond);
    });
  }
}

FaceId LeftPieces::face_of(std::uint32_t slot, std::uint32_t piece) const {
  const std::vector<std::uint32_t>& all = slots_[number_[slot]].piece;
  return FaceId(static_cast<std::size_t>(std::ranges::find(all, piece) - all.begin()));
}

}  // namespace sectile
