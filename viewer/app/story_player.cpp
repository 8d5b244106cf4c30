#include "app/story_player.h"

#include <algorithm>
#include <atomic>
#include <stdexcept>

#include "events/background.h"

namespace sectile::viewer {
namespace {

struct Request {
  std::vector<Solid> operands;
  Operation operation = Operation::unite;
  std::uint64_t number = 0;
  std::optional<SplitBy> split = std::nullopt;

  bool is_same(const Request& other) const {
    return operation == other.operation && is_same_split(other) &&
           std::equal(operands.begin(), operands.end(), other.operands.begin(),
                      other.operands.end(),
                      [](const Solid& a, const Solid& b) { return a.data() == b.data(); });
  }
  bool is_same_split(const Request& other) const {
    if (!split || !other.split) return split.has_value() == other.split.has_value();
    const HalfSpace &p = split->plane, &q = other.split->plane;
    return split->above == other.split->above && p.a == q.a && p.b == q.b && p.c == q.c &&
           p.d == q.d;
  }
};

struct Told {
  std::uint64_t number = 0;  // of the request
  std::shared_ptr<const Story> story;
  std::string error;
};

Story story_of(const Request& request, const std::atomic<bool>& cancel) {
  if (request.split) {
    std::optional<Story> story =
        Story::tell_split(request.operands.front(), *request.split, &cancel);
    if (!story)
      throw std::runtime_error(
          "Steps of a split are told when its plane is parallel to two axes or halves their "
          "angle.");
    return *story;
  }
  BooleanOptions options;
  options.cancel = &cancel;
  Solid a = request.operands.front();
  for (std::size_t i = 1; i + 1 < request.operands.size(); ++i)
    a = boolean(a, request.operands[i], request.operation, options);
  return Story::tell(a, request.operands.back(), request.operation, &cancel);
}

Told tell_story(const Request& request, const std::atomic<bool>& cancel) {
  try {
    auto story = std::make_shared<const Story>(story_of(request, cancel));
    for (const bool eight_way : {false, true}) story->prepare(eight_way);
    return {request.number, std::move(story), {}};
  } catch (const Cancelled&) {
    return {request.number, nullptr,
            "The steps were cancelled. Move an operand or choose Steps again to retell them."};
  } catch (const std::exception& error) {
    return {request.number, nullptr, error.what()};
  }
}

}  // namespace

struct StoryPlayer::Teller {
  Request wanted;
  Background<Request, Told> worker{[](const Request& request, WorkState& state) {
    return std::optional<Told>(tell_story(request, state.cancelled()));
  }};

  void ask(Request request) {
    if (request.is_same(wanted)) return;
    request.number = wanted.number + 1;
    wanted = request;
    worker.request(std::move(request));
  }
};

StoryPlayer::StoryPlayer() : teller_(std::make_unique<Teller>()) {}
StoryPlayer::~StoryPlayer() = default;

void StoryPlayer::tell(const std::vector<Solid>& operands, Operation operation) {
  teller_->ask({operands, operation});
}

void StoryPlayer::tell(const Solid& solid, const SplitBy& split) {
  teller_->ask({{solid}, Operation::intersect, 0, split});
}

void StoryPlayer::forget() {
  teller_->wanted = {{}, Operation::unite, teller_->wanted.number + 1};
  teller_->worker.cancel();
  story_.reset();
  current_.reset();
  error_.clear();
  playing_ = false;
}

bool StoryPlayer::is_busy() const {
  return teller_->worker.is_busy();
}

void StoryPlayer::cancel() {
  teller_->worker.cancel();
}

void StoryPlayer::update(double seconds, bool wait) {
  if (wait) teller_->worker.wait();
  std::optional<Told> told = teller_->worker.take();
  if (told && told->number == teller_->wanted.number) {
    error_ = told->error;
    if (told->story) keep_place(std::move(told->story));
    if (!error_.empty()) {
      story_.reset();
      current_.reset();
    }
  }
  if (playing_ && story_) play_on(seconds);
}

void StoryPlayer::play_on(double seconds) {
  until_next_ -= seconds;
  while (playing_ && until_next_ <= 0) {
    until_next_ += 1 / steps_per_second;
    const std::size_t stop = following_stop(), before = step_;
    next();
    if (step_ == before || step_ == stop) playing_ = false;
  }
}

void StoryPlayer::keep_place(std::shared_ptr<const Story> told) {
  if (!has_wish_ && story_) {
    wished_phase_ = phase_;
    wished_step_ = current_ ? step_ - story_->range(phase_).first : 0;
    has_wish_ = true;
  }
  story_ = std::move(told);
  go_to(0);
  if (has_wish_) {
    has_wish_ = false;
    go_to(wished_phase_, wished_step_);
  }
}

Picture StoryPlayer::picture(const StoryView& view) const {
  return current_ ? story_->picture(step_, view) : story_->picture(phase_, view);
}

void StoryPlayer::go_to(std::size_t step) {
  current_.reset();
  if (!story_ || story_->steps().empty()) return;
  step_ = std::min(step, story_->steps().size() - 1);
  current_ = story_->step(step_);
  phase_ = current_->phase;
}

void StoryPlayer::go_to(Phase phase, std::size_t step_in_phase) {
  if (!story_) {
    wished_phase_ = phase;
    wished_step_ = step_in_phase;
    has_wish_ = true;
    return;
  }
  const auto [first, last] = story_->range(phase);
  if (first < last) return go_to(first + std::min(step_in_phase, last - first - 1));
  // Nothing happened in this phase: it still has a picture.
  step_ = std::min(first, story_->steps().empty() ? 0 : story_->steps().size() - 1);
  phase_ = phase;
  current_.reset();
}

void StoryPlayer::next() {
  if (special_only)
    next_special(false);
  else
    go_to(step_ + 1);
}

void StoryPlayer::previous() {
  if (special_only)
    next_special(true);
  else
    go_to(step_ == 0 ? 0 : step_ - 1);
}

bool StoryPlayer::next_special(bool backwards) {
  if (!story_) return false;
  const std::size_t found = story_->next_special(step_, backwards);
  const bool moved = found != step_;
  go_to(found);
  return moved;
}

std::size_t StoryPlayer::following_stop() const {
  std::size_t nearest = story_->steps().size();
  for (const std::string& stop : stops) {
    const std::size_t found = stop == "special case" ? story_->next_special(step_, false)
                                                     : story_->next_of_kind(step_, stop);
    if (found > step_) nearest = std::min(nearest, found);
  }
  return nearest < story_->steps().size() ? nearest : step_;
}

bool StoryPlayer::next_stop() {
  if (!story_) return false;
  const std::size_t stop = following_stop();
  if (stop == step_) return false;
  go_to(stop);
  return true;
}

void StoryPlayer::play(bool on) {
  playing_ = on && story_;
  until_next_ = 1 / steps_per_second;
  if (playing_ && step_ + 1 >= story_->steps().size()) go_to(0);
}

}  // namespace sectile::viewer
