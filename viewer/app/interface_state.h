// What of a session is only there while a person works: messages, questions, what is typed, the
// tool in hand.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/dialogs.h"
#include "app/messages.h"
#include "app/number_field.h"
#include "app/picture_tool.h"
#include "app/profile_editor.h"
#include "app/recent_files.h"
#include "app/recording.h"
#include "app/tour_guide.h"
#include "scene/scene.h"

namespace sectile::viewer {

/// A name that is being typed in the tree.
struct Renaming {
  NodeId node = 0;  ///< 0: none
  bool begun = false;
  std::string text;
};

/// The desktop's, or one of the program alone.
struct Clipboard {
  std::function<std::string()> read;
  std::function<void(const std::string&)> write;
};

struct InterfaceState {
  Messages messages;
  Dialogs dialogs;
  TourGuide tour;
  std::string dragging;  ///< how far a drag of a handle has come and what it touches, in words
  Renaming renaming;
  TypedField typed;
  Clipboard clipboard;
  RecentFiles recent;
  RecordingPlan recording_plan;
  std::optional<Recording> recording;  ///< under way
  ProfileEditor profile;
  bool context_menu = false;          ///< is to open where the pointer is
  std::unique_ptr<PictureTool> tool;  ///< null: none
  glm::dvec2 pointer{0};              ///< where the mouse is in the picture
  int lit_row = -1;                   ///< of the step's table: the one that is pointed at
  bool adding = false;                ///< the list of primitives is to open
  bool view_panel = false;            ///< the view settings are open
  std::string typed_stop;             ///< a break point that is being typed
  std::pair<std::string, std::string> typed_pair;  ///< vertices of A and of B, for another
  bool wants_to_close = false;
};

}  // namespace sectile::viewer
