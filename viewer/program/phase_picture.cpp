#include "program/phase_picture.h"

#include <stdexcept>

#include "picture/theme.h"
#include "samples/samples.h"
#include "story/half_space_block.h"

namespace sectile::viewer {

StoryOperands sample_operands(const std::string& name) {
  const samples::Sample sample = samples::get(name);
  if (!sample.plane) return {sample.a, sample.b, sample.operation.value_or(Operation::unite)};
  const std::optional<Solid> block = half_space_block(sample.a, *sample.plane, true);
  if (!block) throw std::invalid_argument("the steps of sample " + name + " cannot be told");
  return {sample.a, *block, Operation::intersect};
}

Picture phase_picture(const Story& story, Phase phase, std::size_t step, const StoryView& view,
                      double aspect) {
  const auto [first, end] = story.range(phase);
  if (step != last_step && step >= end - first) {
    throw std::invalid_argument("phase " + std::string(name_of(phase)) + " has only " +
                                std::to_string(end - first) + " steps");
  }
  Picture picture = first == end ? story.picture(phase, view)
                                 : story.picture(step == last_step ? end - 1 : first + step, view);
  picture.surroundings = theme(view.dark).surroundings;
  picture.camera.look_at(picture.bounds(), aspect);
  return picture;
}

}  // namespace sectile::viewer
