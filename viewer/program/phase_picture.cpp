#include "program/phase_picture.h"

#include <stdexcept>

#include "picture/theme.h"
#include "samples/samples.h"

namespace sectile::viewer {

StoryOperands sample_operands(const std::string& name) {
  const samples::Sample sample = samples::get(name);
  if (!sample.plane) return {sample.a, sample.b, sample.operation.value_or(Operation::unite)};
  return {sample.a, {}, Operation::intersect, SplitBy{*sample.plane, true}};
}

Story tell(const StoryOperands& operands) {
  if (!operands.split) return Story::tell(operands.a, operands.b, operands.operation);
  std::optional<Story> story = Story::tell_split(operands.a, *operands.split);
  if (!story) throw std::invalid_argument("the steps of this split cannot be told");
  return *story;
}

void check_step_of(const Story& story, Phase phase, std::size_t step) {
  const auto [first, end] = story.range(phase);
  if (step > end - first) {
    const std::string has = end == first       ? "no steps"
                            : end - first == 1 ? "only one step"
                                               : "only " + std::to_string(end - first) + " steps";
    throw std::invalid_argument("--step " + std::to_string(step) + ": phase " +
                                std::string(name_of(phase)) + " has " + has);
  }
}

Picture phase_picture(const Story& story, Phase phase, std::size_t step, const StoryView& view,
                      double aspect) {
  const auto [first, end] = story.range(phase);
  if (step != last_step) check_step_of(story, phase, step + 1);
  Picture picture = first == end ? story.picture(phase, view)
                                 : story.picture(step == last_step ? end - 1 : first + step, view);
  picture.surroundings = theme(view.dark).surroundings;
  picture.camera.look_at(picture.bounds(), aspect);
  return picture;
}

}  // namespace sectile::viewer
