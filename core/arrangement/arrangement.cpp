#include "sectile/arrangement.h"
#include "parallel/parallel.h"

#include <algorithm>
#include <map>

#include "arrangement/boolean_tree.h"
#include "arrangement/solids.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

using namespace arrangement;

// All solids, in one arrangement of their faces.
class ManySolids {
 public:
  ManySolids(std::span<const Solid> solids, const ArrangementOptions& options)
      : steering_{options.cancel, options.progress},
        facets_(facets_of(solids, geometry_, steering_)),
        kernel_(geometry_),
        tree_(facets_, kernel_) {
    steering_.step(0.1);
    faces_ =
        arrange(facets_, tree_, Counting::oriented, Crowds::divided, geometry_, kernel_, steering_);
    cells_ =
        find_cells(faces_, facets_, tree_, Counting::oriented, InsideOut::keep, kernel_, steering_);
    for (const Winding& winding : cells_.winding)
      for (const auto& [operand, number] : winding)
        if (number != 1) throw InternalError("a solid goes around a point more than once");
    steering_.step(0.8);
  }

  std::vector<SolidCell> cells() const {
    std::map<std::vector<std::uint32_t>, std::vector<std::uint32_t>> by_operands;
    for (std::uint32_t c = 0; c < cells_.winding.size(); ++c) {
      std::vector<std::uint32_t> operands;
      for (const auto& [operand, number] : cells_.winding[c]) operands.push_back(operand);
      if (!operands.empty()) by_operands[std::move(operands)].push_back(c);
    }
    std::vector<SolidCell> result;
    CellsOfSolids solids{std::vector<std::uint32_t>(cells_.winding.size(), none),
                         by_operands.size()};
    for (const auto& [operands, cells] : by_operands) {
      for (const std::uint32_t c : cells)
        solids.solid[c] = static_cast<std::uint32_t>(result.size());
      result.push_back({operands, Solid()});
    }
    const std::vector<SolidBoundary> boundaries = solids.boundaries(cells_);
    parallel::loop(0, result.size(), [&](std::size_t i) {
      steering_.check();
      result[i].solid = Solid(solid_of(faces_, cells_, facets_, geometry_, kernel_, solids,
                                       static_cast<std::uint32_t>(i), boundaries[i],
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
  FacetTree tree_;
  SubFaces faces_;
  Cells cells_;
};

}  // namespace

namespace {

std::vector<Solid> not_empty(std::span<const Solid> solids) {
  std::vector<Solid> result;
  for (const Solid& s : solids)
    if (!s.is_empty()) result.push_back(s);
  return result;
}

// Those whose boxes overlap that of a solid.
std::vector<Solid> near(const Solid& solid, std::span<const Solid> others) {
  if (solid.is_empty()) return {};
  const Box& box = solid.data()->slot_tree().bounds();
  std::vector<Solid> result = not_empty(others);
  result.erase(
      std::remove_if(result.begin(), result.end(),
                     [&](const Solid& s) { return !s.data()->slot_tree().bounds().overlaps(box); }),
      result.end());
  return result;
}

Steering steering_of(const ArrangementOptions& options) {
  return {options.cancel, options.progress};
}

}  // namespace

Solid unite(std::span<const Solid> solids, const ArrangementOptions& options) {
  return combine(not_empty(solids), Operation::unite, steering_of(options));
}

Solid intersect(std::span<const Solid> solids, const ArrangementOptions& options) {
  std::vector<Solid> all = not_empty(solids);
  if (all.size() < solids.size()) all.clear();
  return combine(all, Operation::intersect, steering_of(options));
}

Solid subtract(const Solid& solid, std::span<const Solid> others,
               const ArrangementOptions& options) {
  Steering steering = steering_of(options);
  if (options.progress) steering.progress = [&](double done) { options.progress(0.9 * done); };
  const Solid all = combine(near(solid, others), Operation::unite, steering);
  BooleanOptions how;
  how.cancel = options.cancel;
  if (options.progress) how.progress = [&](double done) { options.progress(0.9 + 0.1 * done); };
  return boolean(solid, all, Operation::subtract, how);
}

std::vector<SolidCell> cells(std::span<const Solid> solids, const ArrangementOptions& options) {
  return ManySolids(solids, options).cells();
}

}  // namespace sectile
