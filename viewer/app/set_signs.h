// Signs that no font has as they are wanted: the operations as Venn diagrams, and ∪ and ∩ so wide
// that nobody reads them as letters.
#pragma once

#include <imgui.h>

namespace sectile::viewer {

class SetSigns {
 public:
  /// Before the atlas is built: makes room in it. `size`: the font's, in pixels.
  void add_to(ImFontAtlas& atlas, ImFont* font, float size);
  /// When it was built: draws them there.
  void draw(ImFontAtlas& atlas) const;

 private:
  struct Place {
    int rectangle = 0;
    ImWchar code = 0;
  };
  ImVector<Place> places_;
};

}  // namespace sectile::viewer
