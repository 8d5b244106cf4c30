#include "boolean/neighborhoods/row_pieces.h"

#include <algorithm>
#include <tuple>

namespace sectile {

void RowPieces::write(const Row& row, const RowOrder& order, const Wanted& wanted,
                      Neighborhoods& found) {
  std::ranges::sort(pieces_, [](const RowPiece& p, const RowPiece& q) {
    return std::tie(p.run, p.from) < std::tie(q.run, q.from);
  });
  first_carrier_ = found.carriers.end_id();
  for (const RowPiece& piece : pieces_) write_piece(piece, row, order, found);
  for (std::size_t i = 0; i < pairs_.size(); ++i)
    for (const RowPair& pair : pairs_[i])
      write_pair(pair, row, wanted.operations[i], found.wedges[i]);
}

void RowPieces::write_piece(const RowPiece& piece, const Row& row, const RowOrder& order,
                            Neighborhoods& found) {
  const Row::Run& run = row.runs[piece.run];
  Carrier carrier;
  carrier.operand = run.operand;
  carrier.entity = run.carrier;
  carrier.end[0] = piece.from == run.from ? run.end[0] : carrier.entity;
  carrier.end[1] = piece.to == run.to ? run.end[1] : carrier.entity;
  carrier.along = order.is_along(piece.run);
  carrier.cut = piece.cut;
  if (carrier.cut && carrier.entity.is_face())
    carrier.direction = order.direction(order.plane(2 * piece.run));
  const CarrierId id = found.carriers.add(carrier);
  const HalfPlaneId first = found.half_planes.end_id();
  for (const RowSide side : {2 * piece.run, 2 * piece.run + 1})
    found.half_planes.add({run.operand, is_forward(side), id, order.face(side), order.plane(side),
                           piece.cls[side % 2]});
  Segment segment{};
  segment.place[0] = row.places[piece.from];
  segment.place[1] = row.places[piece.to];
  segment.carriers = {id, found.carriers.end_id()};
  segment.half_planes = {first, found.half_planes.end_id()};
  for (const unsigned k : {0u, 1u}) segment.plane[k] = order.plane(2 * piece.run + k);
  found.segments.add(segment);
}

// Of the pieces of each side, the one from whose start the half-edge of the result leads stands for
// all: the others continue it.
void RowPieces::write_pair(const RowPair& pair, const Row& row, Operation operation,
                           Wedges& wedges) const {
  const auto pieces_of = [&](RowSide side) {
    return std::pair(piece_from(side / 2, pair.from), piece_from(side / 2, pair.to));
  };
  if (pair.second == beyond_edge(pair.first)) {
    const auto [from, to] = pieces_of(pair.first);
    for (std::size_t i = from; i < to; ++i)
      wedges.pairs.push_back({half_plane(i, pair.first), half_plane(i, pair.second)});
    return;
  }
  const auto first_of = [&](RowSide side) {
    const auto [from, to] = pieces_of(side);
    const bool along = is_forward(side) != reversed(operation, row.runs[side / 2].operand);
    const std::size_t first = along ? from : to - 1;
    for (std::size_t i = from; i < to; ++i)
      if (i != first) wedges.continued.push_back(half_plane(i, side));
    return half_plane(first, side);
  };
  const HalfPlaneId first = first_of(pair.first), second = first_of(pair.second);
  wedges.pairs.push_back({first, second});
}

std::size_t RowPieces::piece_from(std::uint32_t run, std::uint32_t place) const {
  return static_cast<std::size_t>(std::ranges::partition_point(pieces_,
                                                               [&](const RowPiece& p) {
                                                                 return std::tie(p.run, p.from) <
                                                                        std::tie(run, place);
                                                               }) -
                                  pieces_.begin());
}

}  // namespace sectile
