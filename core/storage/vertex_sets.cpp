#include "storage/vertex_sets.h"

#include "parallel/parallel.h"
#include "storage/block_elements.h"

namespace sectile {

void CountedSets::unite(std::uint32_t i, std::uint32_t j) {
  const std::uint32_t first = sets_.first(i), second = sets_.first(j);
  if (first == second) return;
  sets_.unite(first, second);
  --count_;
}

// Only what the blocks have in common is in more than one of them.
VertexSets::VertexSets(const SolidData& solid)
    : number(solid.slots(), [](const Block& b) { return b.vertex_count(); }), sets(number.count) {
  const auto slots = solid.slots();
  struct Ends {
    std::uint32_t from, to;
  };
  const NumbersOfSlots borders(slots, [](const Block& b) { return b.border_count; });
  std::vector<Ends> ends(borders.count);
  parallel::loop(0, slots.size(), [&](std::size_t s) {
    if (slots[s].empty()) return;
    BlockElements(*slots[s].block)
        .each_border_edge([&](std::uint32_t b, std::uint32_t from, std::uint32_t to) {
          Ends& of = ends[borders.first[s] + b];
          of = {number.first[s] + from, number.first[s] + to};
          if (slots[s].turned) std::swap(of.from, of.to);
        });
  });
  for (std::uint32_t s = 0; s < slots.size(); ++s) {
    if (!slots[s].links) continue;
    const std::vector<BorderLink>& links = slots[s].links->all();
    for (std::uint32_t b = 0; b < links.size(); ++b) {
      const std::uint32_t other = s + static_cast<std::uint32_t>(links[b].slots);
      if (other < s) continue;
      const Ends &mine = ends[borders.first[s] + b],
                 &others = ends[borders.first[other] + links[b].border];
      sets.unite(mine.from, others.to);
      sets.unite(mine.to, others.from);
    }
  }
}

}  // namespace sectile
