// Something that takes the pointer and the keys in the picture for itself until it is done or given
// up: moving with the mouse, measuring, placing. One at a time, in Session::tool.
#pragma once

#include <glm/glm.hpp>
#include <string>

#include "events/input.h"
#include "picture/picture.h"

namespace sectile::viewer {

class Session;
struct ViewState;

/// Where the pointer is in the picture, and what is held with it.
struct Pointer {
  glm::dvec2 at{0};
  bool shift = false, control = false;
};

class PictureTool {
 public:
  /// What of the mouse the tool takes. `clicks`: drags still turn the view. `drags`: also drags
  /// with the left button. `all`: the whole window's mouse, no button held.
  enum class Mouse { clicks, drags, all };

  virtual ~PictureTool() = default;
  virtual Mouse mouse() const { return Mouse::clicks; }
  virtual std::string title() const = 0;
  /// What to do next, in one sentence; shown while the tool is there.
  virtual std::string hint(const ViewState& view) const = 0;

  virtual void follow(Session&, const Pointer&) {}  ///< every frame in which the pointer moved
  virtual void press(Session&, const Pointer&) {}   ///< the left button, or the click
  virtual void release(Session&, const Pointer&) {}
  /// A key; false leaves it to the commands. Esc never comes here.
  virtual bool key(Session&, const Event&) { return false; }
  virtual void text(Session&, const std::string&) {}
  virtual void give_up(Session&) {}  ///< Esc, or another tool begins
  /// The scene has changed, as by undo: what was picked may be gone. Called before all else.
  virtual void scene_changed(Session&) {}
  virtual void preview_undone(Session&) {}  ///< undo took away what the tool was showing
  virtual void add_to(Picture&, const ViewState&) const {}

  bool is_done() const { return done_; }

 protected:
  void finish() { done_ = true; }

 private:
  bool done_ = false;
};

}  // namespace sectile::viewer
