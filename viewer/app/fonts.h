// The fonts of the interface, part of the program: Inter with Font Awesome's icons (icons.h) and
// DejaVu's mathematical signs, and DejaVu Sans Mono for tables.
#pragma once

struct ImFont;
struct ImFontAtlas;

namespace sectile::viewer {

struct Fonts {
  ImFont* regular = nullptr;  ///< 15 units, the default
  ImFont* bold = nullptr;     ///< 15
  ImFont* title = nullptr;    ///< 20, bold
  ImFont* small = nullptr;    ///< 12.5
  ImFont* mono = nullptr;     ///< 14
};

/// Replaces what the atlas holds. Glyphs are made for `scale` pixels per unit, so set
/// io.FontGlobalScale to 1 / scale. The renderer uploads the new atlas by itself.
Fonts load_fonts(ImFontAtlas& atlas, float scale);

}  // namespace sectile::viewer
