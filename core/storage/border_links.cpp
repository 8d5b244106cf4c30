#include "storage/border_links.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace sectile {

BorderLinks::BorderLinks(const Block& block, std::vector<BorderLink> links)
    : links_(std::move(links)), by_neighbour_(links_.size()) {
  const auto neighbour = [&](std::uint32_t border) {
    const FaceId face = block.brep.face_of(Brep::half_edge(EdgeId(border)));
    const BorderLink& link = links_[border];
    return std::tuple(link.slots, block.pieces().of_face[face.value()], link.piece);
  };
  std::iota(by_neighbour_.begin(), by_neighbour_.end(), 0u);
  std::stable_sort(by_neighbour_.begin(), by_neighbour_.end(),
                   [&](std::uint32_t i, std::uint32_t j) { return neighbour(i) < neighbour(j); });
  for (std::uint32_t i = 0; i < by_neighbour_.size(); ++i) {
    const auto [slots, own_piece, piece] = neighbour(by_neighbour_[i]);
    if (i == 0 || neighbour(by_neighbour_[i]) != neighbour(by_neighbour_[i - 1]))
      neighbours_.push_back({slots, own_piece, piece, i, i});
    ++neighbours_.back().last;
  }
}

}  // namespace sectile
