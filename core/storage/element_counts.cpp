#include "storage/element_counts.h"

#include "numbers/disjoint_sets.h"

namespace sectile {
namespace {

// Counts how many sets are left when some are united.
class CountedSets {
 public:
  explicit CountedSets(std::size_t count) : sets_(count), count_(count) {}
  void unite(std::uint32_t i, std::uint32_t j) {
    const std::uint32_t first = sets_.first(i), second = sets_.first(j);
    if (first == second) return;
    sets_.unite(first, second);
    --count_;
  }
  std::size_t count() const { return count_; }

 private:
  DisjointSets sets_;
  std::size_t count_;
};

// Numbers for what the blocks have, one slot after another.
struct Numbers {
  std::vector<std::uint32_t> first;  ///< per slot
  std::uint32_t count = 0;

  template <class Count>
  Numbers(std::span<const Slot> slots, const Count& count_of) {
    for (const Slot& slot : slots) {
      first.push_back(count);
      if (!slot.empty()) count += static_cast<std::uint32_t>(count_of(*slot.block));
    }
  }
};

// Blocks have the ends of the edges between them in common.
std::size_t count_vertices(const SolidData& solid) {
  const auto slots = solid.slots();
  const Numbers vertices(slots, [](const Block& b) { return b.brep.vertex_count(); });
  CountedSets sets(vertices.count);
  for (std::uint32_t s = 0; s < slots.size(); ++s) {
    if (slots[s].empty()) continue;
    for (std::uint32_t b = 0; b < slots[s].block->border_count; ++b) {
      const HalfEdgeId here(2 * b);
      const auto [other, there] = solid.across(s, here);
      if (other < s) continue;
      const std::uint32_t mine = vertices.first[s], others = vertices.first[other];
      sets.unite(mine + slots[s].from(here).value(), others + slots[other].to(there).value());
      sets.unite(mine + slots[s].to(here).value(), others + slots[other].from(there).value());
    }
  }
  return sets.count();
}

}  // namespace

ElementCounts element_counts(const SolidData& solid) {
  ElementCounts counts;
  std::size_t borders = 0;
  for (const Slot& slot : solid.slots()) {
    if (slot.empty()) continue;
    const Brep& brep = slot.block->brep;
    counts.edges += brep.edge_count();
    counts.faces += brep.face_count();
    counts.loops += brep.loop_count();
    borders += slot.block->border_count;
  }
  counts.edges -= borders / 2;  // each is in two blocks
  counts.vertices = count_vertices(solid);
  return counts;
}

std::size_t shell_count(const SolidData& solid) {
  const auto slots = solid.slots();
  const Numbers pieces(slots, [](const Block& b) { return b.pieces().count; });
  CountedSets sets(pieces.count);
  for (std::uint32_t s = 0; s < slots.size(); ++s) {
    if (!slots[s].links) continue;
    const std::uint32_t own = slots[s].block->pieces().count;
    for (std::uint32_t p = 0; p < own; ++p)
      for (const BorderLinks::Neighbour& n : slots[s].links->neighbours(*slots[s].block, p))
        sets.unite(pieces.first[s] + p,
                   pieces.first[s + static_cast<std::uint32_t>(n.slots)] + n.piece);
  }
  return sets.count();
}

}  // namespace sectile
