#include "storage/hang_together.h"

#include <utility>

#include "numbers/disjoint_sets.h"

namespace sectile {

bool hang_together(const SolidData& solid) {
  std::vector<std::uint32_t> first(1, 0);  // per slot: its first piece
  for (const Slot& slot : solid.slots()) first.push_back(first.back() + slot.pieces);
  DisjointSets shells(first.back());
  for (std::uint32_t s = 0; s < solid.slots().size(); ++s) {
    const Slot& slot = solid.slot(s);
    if (!slot.links) continue;
    for (std::uint32_t piece = 0; piece < slot.pieces; ++piece)
      for (const BorderLinks::Neighbour& n : slot.links->neighbours(piece))
        shells.unite(first[s] + piece, first[s + static_cast<std::uint32_t>(n.slots)] + n.piece);
  }
  return std::move(shells).numbered().count == 1;
}

}  // namespace sectile
