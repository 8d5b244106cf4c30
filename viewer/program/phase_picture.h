// The pictures of a story as the command line makes them: with a camera that sees everything.
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "story/story.h"

namespace sectile::viewer {

/// What a story is told of.
struct StoryOperands {
  Solid a, b;
  Operation operation = Operation::unite;
  std::optional<SplitBy> split = std::nullopt;  ///< of `a`; then there is no `b`
};

/// The solids of a sample and its figure's own operation. A sample of splitting keeps what is above
/// the plane.
StoryOperands sample_operands(const std::string& name);
Story tell(const StoryOperands& operands);

constexpr std::size_t last_step = std::numeric_limits<std::size_t>::max();

/// After `step` of a phase, counted from 0; a phase in which nothing happened has its picture as
/// its last step. Throws std::invalid_argument if there is no such step.
Picture phase_picture(const Story& story, Phase phase, std::size_t step, const StoryView& view,
                      double aspect);

/// Throws std::invalid_argument if the phase has fewer steps than this; they count from one, and 0
/// is right always.
void check_step_of(const Story& story, Phase phase, std::size_t step);

}  // namespace sectile::viewer
