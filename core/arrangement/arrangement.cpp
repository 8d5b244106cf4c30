#include "sectile/arrangement.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <map>

#include "arrangement/solids.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

using namespace arrangement;

// All solids, arranged.
class ManySolids {
 public:
  ManySolids(std::span<const Solid> solids, const ArrangementOptions& options)
      : steering_{options.cancel, options.progress},
        facets_(facets_of(solids, geometry_, steering_)),
        kernel_(geometry_),
        tree_(tree_of(facets_, geometry_)) {
    steering_.step(0.1);
    faces_ = arrange(facets_, tree_, Counting::oriented, geometry_, kernel_, steering_);
    cells_ =
        find_cells(faces_, facets_, tree_, Counting::oriented, InsideOut::keep, kernel_, steering_);
    for (const Winding& winding : cells_.winding)
      for (const auto& [operand, number] : winding)
        if (number != 1) throw InternalError("a solid goes around a point more than once");
    steering_.step(0.8);
  }

  template <class Covers>
  Solid solid(const Covers& covers) const {
    std::vector<std::uint8_t> in(cells_.winding.size());
    for (std::size_t c = 0; c < in.size(); ++c) in[c] = covers(cells_.winding[c]);
    Solid result(
        solid_of(faces_, cells_, facets_, geometry_, kernel_, in, Merging::all, steering_));
    steering_.step(1.0);
    return result;
  }

  std::vector<SolidCell> cells() const {
    std::map<std::vector<std::uint32_t>, std::vector<std::uint32_t>> by_operands;
    for (std::uint32_t c = 0; c < cells_.winding.size(); ++c) {
      std::vector<std::uint32_t> operands;
      for (const auto& [operand, number] : cells_.winding[c]) operands.push_back(operand);
      if (!operands.empty()) by_operands[std::move(operands)].push_back(c);
    }
    std::vector<SolidCell> result;
    std::vector<const std::vector<std::uint32_t>*> numbers;
    for (const auto& [operands, cells] : by_operands) {
      result.push_back({operands, Solid()});
      numbers.push_back(&cells);
    }
    tbb::parallel_for(std::size_t(0), result.size(), [&](std::size_t i) {
      steering_.check();
      std::vector<std::uint8_t> in(cells_.winding.size(), 0);
      for (const std::uint32_t c : *numbers[i]) in[c] = 1;
      result[i].solid = Solid(solid_of(faces_, cells_, facets_, geometry_, kernel_, in,
                                       Merging::shared, {steering_.cancel, {}}));
    });
    steering_.step(1.0);
    return result;
  }

 private:
  Steering steering_;
  Geometry geometry_;
  Facets facets_;
  Kernel kernel_;
  BoxTree tree_;
  SubFaces faces_;
  Cells cells_;
};

}  // namespace

Solid unite(std::span<const Solid> solids, const ArrangementOptions& options) {
  return ManySolids(solids, options).solid([](const Winding& w) { return !w.empty(); });
}

Solid intersect(std::span<const Solid> solids, const ArrangementOptions& options) {
  const std::size_t all = solids.size();
  if (all == 0) return Solid();
  return ManySolids(solids, options).solid([all](const Winding& w) { return w.size() == all; });
}

Solid subtract(const Solid& solid, std::span<const Solid> others,
               const ArrangementOptions& options) {
  std::vector<Solid> solids{solid};
  solids.insert(solids.end(), others.begin(), others.end());
  return ManySolids(solids, options).solid([](const Winding& w) {
    return w.size() == 1 && w[0].first == 0;
  });
}

std::vector<SolidCell> cells(std::span<const Solid> solids, const ArrangementOptions& options) {
  return ManySolids(solids, options).cells();
}

}  // namespace sectile
