#include "storage/vertex_sets.h"

#include <atomic>

#include "parallel/parallel.h"
#include "storage/block_elements.h"

namespace sectile {

ConcurrentSets NumbersOfSlots::separate() const {
  ConcurrentSets sets(count);
  parallel::loop(parallel::Range<std::size_t>(0, count, 0x4000),
                 [&](const auto& range) { sets.separate(range.begin(), range.end()); });
  return sets;
}

// Only what the blocks have in common is in more than one of them.
VertexSets::VertexSets(const SolidData& solid)
    : number(solid.slots(), [](const Block& b) { return b.vertex_count(); }),
      sets(number.separate()) {
  const auto slots = solid.slots();
  struct Ends {
    std::uint32_t from, to;
  };
  const NumbersOfSlots borders(slots, [](const Block& b) { return b.border_count; });
  UnsetVector<Ends> ends(borders.count);
  parallel::loop(0, slots.size(), [&](std::size_t s) {
    if (slots[s].empty()) return;
    BlockElements(*slots[s].block)
        .each_border_edge([&](std::uint32_t b, std::uint32_t from, std::uint32_t to) {
          Ends& of = ends[borders.first[s] + b];
          of = {number.first[s] + from, number.first[s] + to};
          if (slots[s].turned) std::swap(of.from, of.to);
        });
  });
  std::atomic<std::size_t> united = 0;
  parallel::loop(0, slots.size(), [&](std::size_t i) {
    if (!slots[i].links) return;
    const auto s = static_cast<std::uint32_t>(i);
    const std::vector<BorderLink>& links = slots[s].links->all();
    std::size_t here = 0;
    for (std::uint32_t b = 0; b < links.size(); ++b) {
      const std::uint32_t other = s + static_cast<std::uint32_t>(links[b].slots);
      if (other < s) continue;
      const Ends &mine = ends[borders.first[s] + b],
                 &others = ends[borders.first[other] + links[b].border];
      here += sets.unite(mine.from, others.to) ? 1 : 0;
      here += sets.unite(mine.to, others.from) ? 1 : 0;
    }
    united.fetch_add(here, std::memory_order_relaxed);
  });
  count = number.count - united;
}

}  // namespace sectile
