#include "story/story.h"

#include "story/break_point.h"
#include "story/half_space_block.h"
#include "story/step_texts.h"
#include "story/story_pictures.h"
#include "story/story_record.h"

namespace sectile::viewer {

Story::Story() : record_(std::make_shared<const StoryRecord>()) {}

Story Story::tell(const Solid& a, const Solid& b, Operation operation,
                  const std::atomic<bool>* cancel) {
  Story story;
  story.record_ = record_story(a, b, operation, cancel);
  return story;
}

std::optional<Story> Story::tell_split(const Solid& solid, const SplitBy& split,
                                       const std::atomic<bool>* cancel) {
  const std::optional<Solid> half_space = half_space_block(solid, split.plane, split.above);
  if (!half_space) return std::nullopt;
  Story story;
  story.record_ = record_story(solid, *half_space, Operation::intersect, cancel, split);
  return story;
}

const std::vector<StepRecord>& Story::steps() const {
  return record_->steps;
}

Step Story::step(std::size_t number) const {
  return tell_step(*record_, number);
}

std::pair<std::size_t, std::size_t> Story::range(Phase phase) const {
  const auto p = static_cast<std::size_t>(phase);
  return {record_->first_step[p], record_->first_step[p + 1]};
}

const Solid& Story::result() const {
  return record_->result;
}

Operation Story::operation() const {
  return record_->operation;
}

Picture Story::picture(std::size_t step, const StoryView& view) const {
  return draw_step(*record_, step, view);
}

Picture Story::picture(Phase phase, const StoryView& view) const {
  return draw_phase(*record_, phase, view);
}

Bounds Story::place_of(std::size_t step) const {
  return place_of_step(*record_, step);
}

void Story::prepare(bool eight_way) const {
  record_->operand(0);
  record_->result_mesh();
  record_->four_parts();
  if (eight_way) record_->eight_parts();
}

std::size_t Story::next_special(std::size_t step, bool backwards) const {
  const std::vector<StepRecord>& all = steps();
  if (backwards) {
    for (std::size_t i = std::min(step, all.size()); i-- > 0;)
      if (all[i].special) return i;
  } else {
    for (std::size_t i = step + 1; i < all.size(); ++i)
      if (all[i].special) return i;
  }
  return step;
}

bool Story::has_stop(const std::string& kind_or_entity) const {
  const BreakPoint point(kind_or_entity);
  for (std::size_t i = 0; i < steps().size(); ++i)
    if (point.matches(record_->event(i))) return true;
  return false;
}

std::size_t Story::next_of_kind(std::size_t step, const std::string& kind_or_entity) const {
  const BreakPoint point(kind_or_entity);
  for (std::size_t i = step + 1; i < steps().size(); ++i)
    if (point.matches(record_->event(i))) return i;
  return step;
}

}  // namespace sectile::viewer
