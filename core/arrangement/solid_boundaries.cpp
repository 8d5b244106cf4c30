#include "arrangement/solid_boundaries.h"

#include <array>

namespace sectile::arrangement {
namespace {

class BoundaryFinder {
 public:
  BoundaryFinder(const Cells& cells, const CellsOfSolids& solids)
      : cells_(cells), solids_(solids), found_(solids.count), last_(solids.count, none) {}

  std::vector<SolidBoundary> run() {
    for (std::uint32_t f = 0; f < cells_.before.size(); ++f)
      for (const std::uint32_t s : bounded_by(f))
        if (s != none) found_[s].faces.push_back(f);
    for (std::uint32_t i = 0; i < cells_.fans.size(); ++i)
      add(&SolidBoundary::fans, i, cells_.of(cells_.fans[i]));
    last_.assign(solids_.count, none);
    for (std::uint32_t i = 0; i < cells_.rows.size(); ++i)
      add(&SolidBoundary::rows, i, cells_.rows[i].sides);
    return std::move(found_);
  }

 private:
  std::array<std::uint32_t, 2> bounded_by(std::uint32_t face) const {
    const std::uint32_t before = solids_.solid[cells_.before[face]],
                        behind = solids_.solid[cells_.behind[face]];
    if (before == behind) return {none, none};
    return {before, behind};
  }

  template <class Sides>
  void add(std::vector<std::uint32_t> SolidBoundary::*which, std::uint32_t number,
           const Sides& sides) {
    for (const auto& side : sides)
      for (const std::uint32_t s : bounded_by(cells_.face_of[side.corner])) {
        if (s == none || last_[s] == number) continue;
        last_[s] = number;
        (found_[s].*which).push_back(number);
      }
  }

  const Cells& cells_;
  const CellsOfSolids& solids_;
  std::vector<SolidBoundary> found_;
  std::vector<std::uint32_t> last_;  // per solid: the fan or row that it had last
};

}  // namespace

std::vector<SolidBoundary> CellsOfSolids::boundaries(const Cells& cells) const {
  return BoundaryFinder(cells, *this).run();
}

}  // namespace sectile::arrangement
