#include "arrangement/row_parts.h"

#include <algorithm>
#include <tuple>

#include "sectile/errors.h"

namespace sectile::arrangement {
namespace {

class PartFinder {
 public:
  PartFinder(const Cells& cells, const CellsOfSolids& solids, std::uint32_t solid)
      : cells_(cells), solids_(solids), solid_(solid) {}

  std::vector<RowPart> run(const std::vector<std::uint32_t>& rows) {
    for (const std::uint32_t row : rows) add_wedges(cells_.rows[row]);
    std::sort(parts_.begin(), parts_.end(), [](const RowPart& a, const RowPart& b) {
      return std::tie(a.corner, a.from) < std::tie(b.corner, b.from);
    });
    return std::move(parts_);
  }

 private:
  bool is_in_after(const EdgeRow::Side& s) const {
    const std::uint32_t f = cells_.face_of[s.corner];
    return solids_.solid[s.forward ? cells_.before[f] : cells_.behind[f]] == solid_;
  }
  bool is_in_before(const EdgeRow::Side& s) const {
    const std::uint32_t f = cells_.face_of[s.corner];
    return solids_.solid[s.forward ? cells_.behind[f] : cells_.before[f]] == solid_;
  }

  void add_wedges(const EdgeRow& row) {
    std::vector<std::uint8_t> kept;
    for (const EdgeRow::Side& s : row.sides) kept.push_back(is_in_after(s) != is_in_before(s));
    for (const Neighbours& n : neighbours(row, kept)) {
      const EdgeRow::Side &side = row.sides[n.side], &next = row.sides[n.next];
      if (!is_in_after(side)) continue;
      if (!is_in_before(next))
        throw InternalError("the material around an edge does not alternate");
      for (const EdgeRow::Side* s : {&side, &next})
        parts_.push_back(
            {s->corner, n.from, n.to, wedges_, row.places[n.from], row.places[n.to], s->forward});
      ++wedges_;
    }
  }

  const Cells& cells_;
  const CellsOfSolids& solids_;
  std::uint32_t solid_;
  std::vector<RowPart> parts_;
  std::uint32_t wedges_ = 0;
};

}  // namespace

std::vector<RowPart> row_parts(const Cells& cells, const CellsOfSolids& solids, std::uint32_t solid,
                               const std::vector<std::uint32_t>& rows) {
  return PartFinder(cells, solids, solid).run(rows);
}

}  // namespace sectile::arrangement
