#include "storage/trimmed_blocks.h"

#include <utility>

#include "parallel/parallel.h"

namespace sectile {

TrimmedBlock::TrimmedBlock(const Block& old, std::vector<FaceId> faces)
    : faces_(std::move(faces)),
      local_(old.brep().half_edge_count()),
      made_(old.brep(), old.geometry(), faces_, old.touching_vertices(), local_) {
  std::vector<bool> stays(old.brep().face_count());
  for (const FaceId f : faces_) stays[f.value()] = true;
  made_.number_edges([&](HalfEdgeId h) {
    return old.is_border(h) || !stays[old.brep().face_of(Brep::twin(h)).value()];
  });
  made_.fill();
}

void TrimmedBlocks::trim(std::vector<Rest> rests) {
  parallel::loop(parallel::Range<std::size_t>(0, rests.size(), 4), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i)
      trimmed_[rests[i].slot] = std::make_unique<const TrimmedBlock>(
          *solid_.slot(rests[i].slot).block, std::move(rests[i].faces));
  });
  for (const Rest& rest : rests) slots_.push_back(rest.slot);
}

BorderEdge TrimmedBlocks::border_edge(std::uint32_t slot, HalfEdgeId in_old_block) const {
  const TrimmedBlock* trimmed = trimmed_[slot].get();
  const Block& block = trimmed ? *trimmed->block() : *solid_.slot(slot).block;
  const std::uint32_t border =
      trimmed ? trimmed->border_at(in_old_block) : in_old_block.value() / 2;
  if (border == TrimmedBlock::none) return {slot, border, 0};
  return {slot, border, block.piece_at(Brep::half_edge(EdgeId(border)))};
}

// The link of a slot to the same edge of what is left of its neighbour.
BorderLink TrimmedBlocks::followed(std::uint32_t slot, const BorderLink& link) const {
  const std::uint32_t other = slot + static_cast<std::uint32_t>(link.slots);
  if (!trimmed_[other]) return link;
  const BorderEdge there = border_edge(other, HalfEdgeId(2 * link.border));
  return {link.slots, there.border, there.piece};
}

void TrimmedBlocks::link(SharedSlots& shared, std::uint32_t first) const {
  for (const std::uint32_t slot : slots_) {
    std::vector<BorderLink> links;
    for (const HalfEdgeId old : trimmed_[slot]->borders()) {
      links.push_back({0, TrimmedBlock::none, 0});
      if (!solid_.slot(slot).block->is_border(old)) continue;
      const BorderLink& link = solid_.slot(slot).links->all()[old.value() / 2];
      links.back() = followed(slot, link);
      const std::uint32_t other = slot + static_cast<std::uint32_t>(link.slots);
      if (trimmed_[other] || shared.slots[first + other].empty()) continue;
      const BorderEdge mine = border_edge(slot, old);
      shared.links_of(first + other)[link.border] = {-link.slots, mine.border, mine.piece};
    }
    shared.links_of(first + slot) = std::move(links);
  }
}

}  // namespace sectile
