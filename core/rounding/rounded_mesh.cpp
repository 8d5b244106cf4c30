#include <utility>

#include "import/diagnosis.h"
#include "rounding/plain_rounding.h"
#include "rounding/rounding_attempt.h"
#include "rounding/rounding_steps.h"
#include "sectile/rounding.h"

namespace sectile {
namespace {

void bound_displacement(const RoundingReport& report, const Rounding& options) {
  if (report.largest_move <= options.max_move) return;
  throw RoundingFailed("the corner at " + in_words(report.largest_at) + " would move by " +
                           in_words(report.largest_move) +
                           ", farther than is allowed; allow more, or use finer numbers",
                       report.largest_at);
}

// Where changes nearby do not help, the corners there go to a coarser grid, and what they bound
// then is rounded anew. Each grid is coarser and reaches farther than the last, until all corners
// are at one place: so it ends. Where there is no room near by to separate what touches, what is
// thinner than a step may be in the way: that vanishes first, and nothing that is thicker. If that
// is not enough, a coarser grid makes room.
RoundedMesh round_until_legal(std::shared_ptr<const SolidData> data, const Rounding& options) {
  const RoundingGrid grid(options);
  RoundingSteps steps(options);
  if (!options.separate_touching)
    if (auto plain = plain_rounding(*data, grid, options, steps)) {
      bound_displacement(plain->report, options);
      steps.finish();
      return std::move(*plain);
    }
  RoundedMesh result;
  Displacement moved;
  bool was_cramped = false;
  auto lines =
      options.separate_touching ? RoundedSurface::Lines::apart : RoundedSurface::Lines::divided;
  for (double coarseness = 1;;) {
    RoundingAttempt attempt(*data, grid, options, lines, moved, steps);
    if (result.report.corners == 0) result.report.corners = attempt.corners();
    if (attempt.run()) {
      attempt.take(result);
      break;
    }
    if (attempt.has_lines_that_meet()) {
      lines = RoundedSurface::Lines::divided;
      continue;
    }
    Displacement farther;
    const bool on_its_grid = attempt.is_cramped() && !std::exchange(was_cramped, true);
    data = attempt.coarser(on_its_grid ? 1 : coarseness *= 4, farther);
    moved = std::move(farther);
    ++result.report.resolved;
    result.report.largest_move = moved.largest();
    result.report.largest_at = moved.largest_at();
    if (data->empty()) break;
    bound_displacement(result.report, options);
  }
  bound_displacement(result.report, options);
  steps.finish();
  return result;
}

}  // namespace

RoundedMesh rounded_mesh(const Solid& solid, const Rounding& rounding) {
  if (solid.is_empty()) {
    RoundingSteps(rounding).finish();
    return {};
  }
  return round_until_legal(solid.data(), rounding);
}

}  // namespace sectile
