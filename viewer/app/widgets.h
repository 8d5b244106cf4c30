// Where the named widgets of the last frame are, so that tests press them by name and check that
// nothing overlaps and nothing is cut off.
#pragma once

#include <glm/glm.hpp>
#include <map>
#include <string>

namespace sectile::viewer {

struct Widget {
  glm::vec4 rectangle{0};  ///< x, y, width, height in UI units
  glm::vec4 seen{0};       ///< what is left of it in a panel that scrolls up and down; may be empty
  bool clipped = false;   ///< part of it, or of its text, cannot be seen, and scrolling brings none
  bool surface = false;   ///< a panel that others stand on
  bool floating = false;  ///< in a menu, a dialog or a tooltip above the rest
  bool enabled = true;
};

class Widgets {
 public:
  void begin_frame() { widgets_.clear(); }
  /// Takes the rectangle of ImGui's last item. `text_width` is how wide its text is, to see whether
  /// it fits.
  void record_item(const std::string& name, bool enabled = true, float text_width = 0);
  void record(const std::string& name, Widget widget);
  /// The last item is a text of its own, called by how it begins.
  void record_text(const std::string& text);
  /// The same for an item on which others stand.
  void record_surface(const std::string& name);
  /// Records the current ImGui window as a surface.
  void record_window(const std::string& name);

  const std::map<std::string, Widget>& all() const { return widgets_; }
  const Widget* find(const std::string& name) const;

 private:
  std::map<std::string, Widget> widgets_;
};

}  // namespace sectile::viewer
