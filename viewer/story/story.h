// The story of one Boolean: every phase and every step in it, in words, tables and pictures.
//
// A story keeps what the phases reported; steps and pictures are made from that when asked for.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "picture/picture.h"
#include "sectile/sectile.h"
#include "story/step.h"

namespace sectile::viewer {

/// What the pictures of a story show besides the step itself.
struct StoryView {
  bool eight_way = false;
  double exploded = 0;  ///< 0 … 1: parts, and the ends of null edges, pulled apart
  bool labels = false;
  bool dark = false;
  int lit_row = -1;  ///< of the present step's table; -1: none
  bool operator==(const StoryView&) const = default;
};

/// What a split is told with: the plane of section 3, and which side is kept.
struct SplitBy {
  HalfSpace plane;
  bool above = true;
};

struct StoryRecord;

/// Cheap to copy; safe to read from many threads.
class Story {
 public:
  Story();  ///< without any steps
  /// Runs the operation with an observer; throws Cancelled, InternalError, … as boolean() does.
  static Story tell(const Solid& a, const Solid& b, Operation operation,
                    const std::atomic<bool>* cancel = nullptr);
  /// The same for a split, told as in section 3: half-space, plane, above, on and below. Nothing if
  /// doubles cannot hold the plane within the solid's surroundings.
  static std::optional<Story> tell_split(const Solid& solid, const SplitBy& split,
                                         const std::atomic<bool>* cancel = nullptr);

  /// All steps, phase by phase in order.
  const std::vector<StepRecord>& steps() const;
  Step step(std::size_t number) const;
  /// First step of a phase and one past its last.
  std::pair<std::size_t, std::size_t> range(Phase phase) const;
  const Solid& result() const;
  Operation operation() const;

  /// What to draw after `step` (all steps before it of the same phase are drawn too, fainter).
  /// Every phase has its own picture. Camera and surroundings are left to the caller.
  Picture picture(std::size_t step, const StoryView& view) const;
  /// The same for a phase in which nothing happened: what it starts from.
  Picture picture(Phase phase, const StoryView& view) const;
  /// The surroundings of a step, for the camera.
  Bounds place_of(std::size_t step) const;
  /// Makes the surfaces that pictures need, some of which take as long as the operation itself;
  /// otherwise the first picture does.
  void prepare(bool eight_way) const;

  /// The next (or previous) step that is special; `step` if there is none.
  std::size_t next_special(std::size_t step, bool backwards) const;
  /// The next step after `step` that a break point names; `step` if there is none. Break points
  /// are kinds ("null edge"), kinds of contacts ("vertex on vertex", in either order), entities
  /// ("v12", "A v12") and pairs of them, A's first ("v12 on v3").
  std::size_t next_of_kind(std::size_t step, const std::string& kind_or_entity) const;
  /// Does a break point name any step?
  bool has_stop(const std::string& kind_or_entity) const;

 private:
  std::shared_ptr<const StoryRecord> record_;
};

}  // namespace sectile::viewer
