#include "storage/border_links.h"

#include <algorithm>
#include <utility>

namespace sectile {

namespace {

// Two numbers for four, as most of the time goes into comparing them.
struct Entry {
  std::uint64_t own_piece_and_slots, piece_and_border;

  Entry(std::uint32_t own_piece, const BorderLink& link, std::uint32_t border)
      : own_piece_and_slots(std::uint64_t(own_piece) << 32 |
                            static_cast<std::uint32_t>(link.slots)),
        piece_and_border(std::uint64_t(link.piece) << 32 | border) {}

  std::uint32_t own_piece() const { return static_cast<std::uint32_t>(own_piece_and_slots >> 32); }
  std::uint32_t border() const { return static_cast<std::uint32_t>(piece_and_border); }
  bool same_neighbour(const Entry& other) const {
    return own_piece_and_slots == other.own_piece_and_slots &&
           piece_and_border >> 32 == other.piece_and_border >> 32;
  }
  friend bool operator<(const Entry& a, const Entry& b) {
    return a.own_piece_and_slots != b.own_piece_and_slots
               ? a.own_piece_and_slots < b.own_piece_and_slots
               : a.piece_and_border < b.piece_and_border;
  }
};

}  // namespace

void BorderLinks::find_neighbours(const Block& block) const {
  const Pieces& pieces = block.pieces();
  std::vector<Entry> entries;
  entries.reserve(links_.size());
  for (std::uint32_t border = 0; border < links_.size(); ++border) {
    entries.emplace_back(block.piece_at(Brep::half_edge(EdgeId(border))), links_[border], border);
  }
  std::sort(entries.begin(), entries.end());
  by_neighbour_.reserve(entries.size());
  first_.reserve(pieces.count() + 1);
  for (std::uint32_t i = 0; i < entries.size(); ++i) {
    const Entry& e = entries[i];
    const BorderLink& link = links_[e.border()];
    by_neighbour_.push_back(e.border());
    first_.resize(e.own_piece() + 1, static_cast<std::uint32_t>(neighbours_.size()));
    if (i == 0 || !e.same_neighbour(entries[i - 1]))
      neighbours_.push_back({link.slots, link.piece, i, i});
    ++neighbours_.back().last;
  }
  first_.resize(pieces.count() + 1, static_cast<std::uint32_t>(neighbours_.size()));
  if (pieces.count() == 1) first_ = {};
}

}  // namespace sectile
