#include "storage/vertex_sets.h"

namespace sectile {

void CountedSets::unite(std::uint32_t i, std::uint32_t j) {
  const std::uint32_t first = sets_.first(i), second = sets_.first(j);
  if (first == second) return;
  sets_.unite(first, second);
  --count_;
}

VertexSets::VertexSets(const SolidData& solid)
    : number(solid.slots(), [](const Block& b) { return b.vertex_count(); }), sets(number.count) {
  const auto slots = solid.slots();
  for (std::uint32_t s = 0; s < slots.size(); ++s) {
    if (slots[s].empty()) continue;
    for (std::uint32_t b = 0; b < slots[s].block->border_count; ++b) {
      const HalfEdgeId here(2 * b);
      const auto [other, there] = solid.across(s, here);
      if (other < s) continue;
      const std::uint32_t mine = number.first[s], others = number.first[other];
      sets.unite(mine + slots[s].from(here).value(), others + slots[other].to(there).value());
      sets.unite(mine + slots[s].to(here).value(), others + slots[other].from(there).value());
    }
  }
}

}  // namespace sectile
