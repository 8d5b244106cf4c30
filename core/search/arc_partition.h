// Which of very many arcs of directions meet (search/seen_arc.h).
//
// On the surface of a cube around the point from which they are seen, arcs are line segments. As a
// rule few of their boxes overlap; where arcs are long and aslant very many do, and then the cube
// is divided by planes through its middle, along arcs, until there are few in each part of it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_set>
#include <utility>
#include <vector>

#include "search/seen_arc.h"
#include "search/space_partition.h"

namespace sectile {

class ArcPartition {
 public:
  /// Of two arcs with one label (per arc) there is no pair; without labels, all differ.
  explicit ArcPartition(std::span<const SeenArc> arcs, std::span<const std::uint32_t> labels = {});

  /// Calls visit(i, j), i < j, once for each two arcs that meet, and for few others.
  template <class Visit>
  void for_each_pair(const Visit& visit) const {
    if (const auto pairs = few_by_boxes()) {
      for (const auto& [i, j] : *pairs) visit(i, j);
      return;
    }
    std::unordered_set<std::uint64_t> known;
    const SpacePartition space(rods_.rod, rods_.label, SpacePartition::Planes::through_origin);
    for (const SpacePartition::Cell& cell : space.cells(1))
      space.for_each_pair(cell, [&](std::uint32_t i, std::uint32_t j) {
        const auto [f, g] = std::minmax(rods_.arc[i], rods_.arc[j]);
        if (f != g && !are_apart(rods_.rod[i], rods_.rod[j]) &&
            known.insert(std::uint64_t(f) << 32 | g).second)
          visit(f, g);
      });
  }

 private:
  struct Rods {
    std::vector<SpacePartition::Rod> rod;
    std::vector<std::uint32_t> arc, label;

    void add(const SeenArc& seen, std::uint32_t number, std::uint32_t its_label);
  };

  static bool are_apart(const SpacePartition::Rod& r, const SpacePartition::Rod& s);
  /// The pairs, if boxes tell most of them apart.
  std::optional<std::vector<std::pair<std::uint32_t, std::uint32_t>>> few_by_boxes() const;

  Rods rods_;
};

/// Calls visit(i, j) for arc i of the first ones and j of the others, as above.
template <class Visit>
void for_each_pair_of_arcs(std::span<const SeenArc> first, std::span<const SeenArc> others,
                           const Visit& visit) {
  std::vector<SeenArc> arcs(first.begin(), first.end());
  arcs.insert(arcs.end(), others.begin(), others.end());
  std::vector<std::uint32_t> labels(arcs.size(), 0);
  std::fill(labels.begin() + static_cast<std::ptrdiff_t>(first.size()), labels.end(), 1);
  ArcPartition(arcs, labels).for_each_pair([&](std::uint32_t i, std::uint32_t j) {
    visit(i, j - static_cast<std::uint32_t>(first.size()));
  });
}

}  // namespace sectile
