#include "storage/element_counts.h"

#include "storage/vertex_sets.h"

namespace sectile {

ElementCounts element_counts(const SolidData& solid) {
  ElementCounts counts;
  std::size_t borders = 0;
  for (const Slot& slot : solid.slots()) {
    if (slot.empty()) continue;
    counts.edges += slot.block->half_edge_count() / 2;
    counts.faces += slot.block->face_count();
    counts.loops += slot.block->loop_count();
    borders += slot.block->border_count;
  }
  counts.edges -= borders / 2;  // each is in two blocks
  counts.vertices = VertexSets(solid).sets.count();
  return counts;
}

std::size_t shell_count(const SolidData& solid) {
  const auto slots = solid.slots();
  const NumbersOfSlots pieces(slots, [](const Block& b) { return b.pieces().count(); });
  CountedSets sets(pieces.count);
  for (std::uint32_t s = 0; s < slots.size(); ++s) {
    if (!slots[s].links) continue;
    const std::uint32_t own = slots[s].block->pieces().count();
    for (std::uint32_t p = 0; p < own; ++p)
      for (const BorderLinks::Neighbour& n : slots[s].links->neighbours(*slots[s].block, p))
        sets.unite(pieces.first[s] + p,
                   pieces.first[s + static_cast<std::uint32_t>(n.slots)] + n.piece);
  }
  return sets.count();
}

}  // namespace sectile
