// What a sweep finds along a row: pieces of edges and faces along which nothing changes, and from
// where to where two half-planes bound one wedge.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "boolean/neighborhoods/row_order.h"

namespace sectile {

/// Places are numbered as in the row.
struct RowPiece {
  std::uint32_t run, from, to;
  std::array<Class, 2> cls;  ///< of its two sides
  bool cut;                  ///< do its sides have different fates, or end in different wedges?
};

/// The first one starts the material. Both runs have ends of pieces at both places.
struct RowPair {
  RowSide first, second;
  std::uint32_t from, to;
};

class RowPieces {
 public:
  /// Pairs for so many operations.
  explicit RowPieces(std::size_t operations) : pairs_(operations) {}

  void add(const RowPiece& piece) { pieces_.push_back(piece); }
  void add(std::size_t operation, const RowPair& pair) { pairs_[operation].push_back(pair); }

  /// Adds a segment with one carrier for each piece, and the wedges.
  void write(const Row& row, const RowOrder& order, const Wanted& wanted, Neighborhoods& found);

 private:
  static void write_piece(const RowPiece& piece, const Row& row, const RowOrder& order,
                          Neighborhoods& found);
  void write_pair(const RowPair& pair, const Row& row, Operation operation, Wedges& wedges) const;
  HalfPlaneId half_plane(std::size_t piece, RowSide side) const {
    return HalfPlaneId(2 * (first_carrier_.value() + piece) + side % 2);
  }
  std::size_t piece_from(std::uint32_t run, std::uint32_t place) const;

  std::vector<RowPiece> pieces_;
  std::vector<std::vector<RowPair>> pairs_;
  CarrierId first_carrier_;
};

}  // namespace sectile
