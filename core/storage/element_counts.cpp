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

// Blocks have the ends of the edges between them in common.
std::size_t count_vertices(const SolidData& solid) {
  const auto slots = solid.slots();
  std::vector<std::uint32_t> first;
  std::uint32_t vertices = 0;
  for (const Slot& slot : slots) {
    first.push_back(vertices);
    if (!slot.empty()) vertices += static_cast<std::uint32_t>(slot.block->brep.vertex_count());
  }
  CountedSets sets(vertices);
  for (std::uint32_t s = 0; s < slots.size(); ++s) {
    if (slots[s].empty()) continue;
    for (std::uint32_t b = 0; b < slots[s].block->border_count; ++b) {
      const HalfEdgeId here(2 * b);
      const auto [other, there] = solid.across(s, here);
      if (other < s) continue;
      sets.unite(first[s] + slots[s].from(here).value(),
                 first[other] + slots[other].to(there).value());
      sets.unite(first[s] + slots[s].to(here).value(),
                 first[other] + slots[other].from(there).value());
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
  std::vector<std::uint32_t> first;
  std::uint32_t pieces = 0;
  for (const Slot& slot : slots) {
    first.push_back(pieces);
    if (!slot.empty()) pieces += slot.block->pieces().count;
  }
  CountedSets sets(pieces);
  for (std::uint32_t s = 0; s < slots.size(); ++s) {
    if (!slots[s].links) continue;
    const std::uint32_t own = slots[s].block->pieces().count;
    for (std::uint32_t p = 0; p < own; ++p)
      for (const BorderLinks::Neighbour& n : slots[s].links->neighbours(*slots[s].block, p))
        sets.unite(first[s] + p, first[s + static_cast<std::uint32_t>(n.slots)] + n.piece);
  }
  return sets.count();
}

}  // namespace sectile
