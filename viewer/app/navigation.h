// What the mouse does in the picture: camera gestures, selecting, dragging handles.
#pragma once

#include <memory>
#include <vector>

#include "app/layout.h"
#include "app/session.h"
#include "app/widgets.h"
#include "events/input.h"
#include "picture/picture.h"

namespace sectile::viewer {

class Navigation {
 public:
  Navigation();
  ~Navigation();
  /// Reacts to ImGui's mouse of this frame; `place` is the picture's rectangle.
  void update(Session& session, const Rectangle& place);
  /// Esc: takes a drag back. False if there was none.
  bool escape(Session& session);
  /// Keys and texts for the tool that is there. False: the key is none of its business.
  bool key(Session& session, const Event& event);
  void text(Session& session, const std::string& typed);
  /// Handles, and whatever else the gestures show, on top of the scene.
  void add_to(Picture& picture, const Session& session) const;
  bool is_dragging() const;
  /// The grips of the handles, as widgets "handle.x", …
  void record(Widgets& widgets, const Session& session, const Rectangle& place) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sectile::viewer
