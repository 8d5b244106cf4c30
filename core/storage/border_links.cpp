#include "storage/border_links.h"

#include <algorithm>
#include <compare>
#include <utility>

namespace sectile {

namespace {

struct Entry {
  std::int32_t slots;
  std::uint32_t own_piece, piece, border;

  bool same_neighbour(const Entry& other) const {
    return slots == other.slots && own_piece == other.own_piece && piece == other.piece;
  }
  friend auto operator<=>(const Entry&, const Entry&) = default;
};

}  // namespace

BorderLinks::BorderLinks(const Block& block, std::vector<BorderLink> links)
    : links_(std::move(links)) {
  std::vector<Entry> entries;
  entries.reserve(links_.size());
  for (std::uint32_t border = 0; border < links_.size(); ++border) {
    const FaceId face = block.brep.face_of(Brep::half_edge(EdgeId(border)));
    const BorderLink& link = links_[border];
    entries.push_back({link.slots, block.pieces().of_face[face.value()], link.piece, border});
  }
  std::sort(entries.begin(), entries.end());
  by_neighbour_.reserve(entries.size());
  for (std::uint32_t i = 0; i < entries.size(); ++i) {
    const Entry& e = entries[i];
    by_neighbour_.push_back(e.border);
    if (i == 0 || !e.same_neighbour(entries[i - 1]))
      neighbours_.push_back({e.slots, e.own_piece, e.piece, i, i});
    ++neighbours_.back().last;
  }
}

}  // namespace sectile
