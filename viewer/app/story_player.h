// Tells the story of a Boolean away from the user interface's thread, and keeps the place in it:
// the current step, playing, break points.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "story/story.h"

namespace sectile::viewer {

class StoryPlayer {
 public:
  StoryPlayer();
  ~StoryPlayer();  ///< cancels what is being told
  StoryPlayer(const StoryPlayer&) = delete;
  StoryPlayer& operator=(const StoryPlayer&) = delete;

  /// Asks for the story of the last operation in ((s0 op s1) op s2) …; the same again is nothing
  /// new. The place is kept: the same phase, and as far into it as there are steps.
  void tell(const std::vector<Solid>& operands, Operation operation);
  /// Asks for the story of a split.
  void tell(const Solid& solid, const SplitBy& split);
  void forget();  ///< there is no story to tell
  /// Takes over what was told in the meantime, and plays on. `wait`: until it is told.
  void update(double seconds, bool wait);

  const Story* story() const { return story_.get(); }
  std::shared_ptr<const Story> shared() const { return story_; }
  bool is_busy() const;
  void cancel();
  const std::string& error() const { return error_; }

  std::size_t step() const { return step_; }
  /// The present step; null without a story, and in a phase in which nothing happened.
  const Step* current() const { return current_ ? &*current_ : nullptr; }
  Phase phase() const { return phase_; }
  Picture picture(const StoryView& view) const;  ///< of the present place; there must be a story
  void go_to(std::size_t step);
  void go_to(Phase phase, std::size_t step_in_phase);
  void next();
  void previous();
  /// Stepping and playing go from special case to special case.
  bool special_only = false;
  bool next_special(bool backwards);  ///< false: there is none
  bool next_stop();                   ///< the next step at which a break point stops

  bool is_playing() const { return playing_; }
  void play(bool on);
  double steps_per_second = 2;

  /// What Story::next_of_kind takes, or "special case"; empty: plays to the end.
  std::vector<std::string> stops;

 private:
  struct Teller;
  void keep_place(std::shared_ptr<const Story> told);
  std::size_t following_stop() const;  ///< the present step if there is none
  void play_on(double seconds);

  std::unique_ptr<Teller> teller_;
  std::shared_ptr<const Story> story_;
  std::string error_;
  std::size_t step_ = 0;
  Phase phase_ = Phase::reduction;
  std::optional<Step> current_;
  bool playing_ = false;
  double until_next_ = 0;
  bool has_wish_ = false;  ///< a place asked for before the story was there
  Phase wished_phase_ = Phase::reduction;
  std::size_t wished_step_ = 0;
};

}  // namespace sectile::viewer
