#include "storage/element_counts.h"

#include <atomic>

#include "parallel/parallel.h"
#include "storage/block_elements.h"
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
  counts.vertices = VertexSets(solid).count;
  return counts;
}

std::size_t shell_count(const SolidData& solid) {
  const auto slots = solid.slots();
  const NumbersOfSlots pieces(slots, [](const Block& b) { return b.pieces().count(); });
  ConcurrentSets sets = pieces.separate();
  std::atomic<std::size_t> united = 0;
  parallel::loop(0, slots.size(), [&](std::size_t s) {
    if (!slots[s].links) return;
    const Block& block = *slots[s].block;
    const bool several = block.pieces().count() > 1;
    const std::vector<FaceId> faces =
        several ? BlockElements(block).faces_at_border() : std::vector<FaceId>();
    const std::vector<BorderLink>& links = slots[s].links->all();
    std::size_t here = 0;
    for (std::uint32_t b = 0; b < links.size(); ++b) {
      if (links[b].slots < 0) continue;  // the neighbour tells
      if (!several && b > 0 && links[b].slots == links[b - 1].slots &&
          links[b].piece == links[b - 1].piece)
        continue;
      const std::uint32_t own = several ? block.pieces().of(faces[b]) : 0;
      const std::size_t other = s + static_cast<std::size_t>(links[b].slots);
      here += sets.unite(pieces.first[s] + own, pieces.first[other] + links[b].piece) ? 1 : 0;
    }
    united.fetch_add(here, std::memory_order_relaxed);
  });
  return pieces.count - united;
}

}  // namespace sectile
