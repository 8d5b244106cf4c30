// Feeds events to Dear ImGui so that none is lost: ImGui looks at the state of keys and buttons
// once a frame, so a press and a release that arrive together take two frames.
#pragma once

#include <deque>
#include <vector>

#include "events/input.h"

namespace sectile::viewer {

class EventQueue {
 public:
  void add(const Input& input);
  /// Hands ImGui as many events as one frame can show, in order, and returns them.
  std::vector<Event> feed();
  bool is_empty() const { return waiting_.empty(); }

 private:
  std::deque<Event> waiting_;
};

}  // namespace sectile::viewer
