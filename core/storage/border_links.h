// What lies beyond the edges that leave a block, seen from its slot.
#pragma once

#include <cstdint>
#include <span>
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
  BorderLinks(const Block& block, std::vector<BorderLink> links);

  const std::vector<BorderLink>& all() const { return links_; }

  /// A piece of a neighbouring block, with the border edges that lead to it from one of the own.
  struct Neighbour {
    std::int32_t slots;
    std::uint32_t piece;
    std::uint32_t first, last;
  };
  /// Those of one of the block's pieces.
  std::span<const Neighbour> neighbours(std::uint32_t own_piece) const {
    if (first_.empty()) return neighbours_;
    return std::span(neighbours_)
        .subspan(first_[own_piece], first_[own_piece + 1] - first_[own_piece]);
  }
  std::span<const std::uint32_t> borders(const Neighbour& n) const {
    return std::span(by_neighbour_).subspan(n.first, n.last - n.first);
  }

 private:
  // Per piece: its first neighbour; and the end. Empty if there is one piece.
  std::vector<std::uint32_t> first_;
  std::vector<Neighbour> neighbours_;
  std::vector<BorderLink> links_;
  std::vector<std::uint32_t> by_neighbour_;
};

}  // namespace sectile
