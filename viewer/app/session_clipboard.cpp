// Copying, cutting, pasting.
#include "app/session.h"
#include "scene/scene_clip.h"

namespace sectile::viewer {

void Session::copy_selected() {
  const Selection chosen = topmost_selected();
  if (chosen.empty()) return;
  interface.clipboard.write(copied_text(scene(), chosen));
  interface.messages.tell(chosen.size() == 1 ? "Copied."
                                             : std::to_string(chosen.size()) + " solids copied.");
}

void Session::cut_selected() {
  if (selection().empty()) return;
  copy_selected();
  remove_selected();
}

void Session::paste() {
  Scene clip;
  try {
    clip = copied_scene(interface.clipboard.read());
  } catch (const std::exception&) {
    interface.messages.error(
        "The clipboard holds no solids. Copy some first (Ctrl+C), here or in another "
        "window.");
    return;
  }
  Selection made;
  if (change("Paste", [&](Scene& changed) { made = insert(changed, clip); })) select(made);
}

}  // namespace sectile::viewer
