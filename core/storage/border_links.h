// What lies beyond the edges that leave a block, seen from its slot.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "storage/block.h"

namespace sectile {

/// The same edge in a neighbouring block: so many slots further on, the border edge of that number.
/// It stays true when all slots of a solid are appended to those of another.
struct BorderLink {
  std::int32_t slots = 0;
  std::uint32_t border = 0;
  std::uint32_t piece = 0;  ///< of the neighbour
};

class BorderLinks {
 public:
  /// Per border edge of the block.
  explicit BorderLinks(std::vector<BorderLink> links) : links_(std::move(links)) {}

  const std::vector<BorderLink>& all() const { return links_; }

  /// A piece of a neighbouring block, with the border edges that lead to it from one of the own.
  struct Neighbour {
    std::int32_t slots;
    std::uint32_t piece;
    std::uint32_t first, last;
  };
  /// Those of one of the pieces of the block, which is always the same one. Found when first asked
  /// for, and then kept: most links are never asked.
  std::span<const Neighbour> neighbours(const Block& block, std::uint32_t own_piece) const {
    once_.run([&] { find_neighbours(block); });
    if (first_.empty()) return neighbours_;
    return std::span(neighbours_)
        .subspan(first_[own_piece], first_[own_piece + 1] - first_[own_piece]);
  }
  std::span<const std::uint32_t> borders(const Neighbour& n) const {
    return std::span(by_neighbour_).subspan(n.first, n.last - n.first);
  }

 private:
  void find_neighbours(const Block& block) const;

  std::vector<BorderLink> links_;
  mutable OnceFlag once_;
  // Per piece: its first neighbour; and the end. Empty if there is one piece.
  mutable std::vector<std::uint32_t> first_;
  mutable std::vector<Neighbour> neighbours_;
  mutable std::vector<std::uint32_t> by_neighbour_;
};

}  // namespace sectile
