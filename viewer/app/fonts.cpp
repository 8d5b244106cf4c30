#include "app/fonts.h"

#include <imgui.h>
#include <imgui_freetype.h>

#include "app/set_signs.h"
#include "render/embedded.h"

namespace sectile::viewer {
namespace {

// Latin, Greek, punctuation, arrows, letter-like signs.
constexpr ImWchar text_ranges[] = {0x0020, 0x024f, 0x0370, 0x03ff, 0x2010, 0x2044,
                                   0x20ac, 0x20ac, 0x2190, 0x21ff, 0};
// What Inter lacks: mathematical operators (∪ ∩ ∖ ⊂ ∈ …), geometric shapes, sub- and superscripts.
constexpr ImWchar sign_ranges[] = {0x2070, 0x209c, 0x2100, 0x214f, 0x2200,
                                   0x22ff, 0x25a0, 0x25ff, 0};
constexpr ImWchar mono_ranges[] = {0x0020, 0x024f, 0x0370, 0x03ff, 0x2010, 0x2044, 0x2190,
                                   0x21ff, 0x2200, 0x22ff, 0x2500, 0x25ff, 0};
constexpr ImWchar icon_ranges[] = {0xf000, 0xf2ff, 0};

class Loader {
 public:
  Loader(ImFontAtlas& atlas, float scale) : atlas_(atlas), scale_(scale) {}

  ImFont* add(const char* file, float size, const ImWchar* ranges, bool merge = false,
              float lower = 0) {
    const std::string_view bytes = embedded_file(file);
    ImFontConfig config;
    config.FontDataOwnedByAtlas = false;  // it is part of the program
    config.MergeMode = merge;
    config.OversampleH = config.OversampleV = 1;
    config.PixelSnapH = true;
    config.GlyphOffset.y = lower * scale_;
    config.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
    return atlas_.AddFontFromMemoryTTF(const_cast<char*>(bytes.data()),
                                       static_cast<int>(bytes.size()), size * scale_, &config,
                                       ranges);
  }

  ImFont* add_text(const char* file, float size) {
    ImFont* font = add(file, size, text_ranges);
    add("DejaVuSansMono.ttf", size * 0.95f, sign_ranges, true);
    add("FontAwesome.ttf", size * 0.95f, icon_ranges, true, size * 0.06f);
    signs_.add_to(atlas_, font, size * scale_);
    return font;
  }

  void build() {
    atlas_.Build();
    signs_.draw(atlas_);
  }

 private:
  ImFontAtlas& atlas_;
  float scale_;
  SetSigns signs_;
};

}  // namespace

Fonts load_fonts(ImFontAtlas& atlas, float scale) {
  atlas.Clear();
  atlas.SetTexID(nullptr);
  atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  atlas.Flags |= ImFontAtlasFlags_NoPowerOfTwoHeight;
  Loader loader(atlas, scale);
  Fonts fonts;
  fonts.regular = loader.add_text("Inter-Regular.otf", 15);
  fonts.bold = loader.add_text("Inter-SemiBold.otf", 15);
  fonts.title = loader.add_text("Inter-SemiBold.otf", 20);
  fonts.small = loader.add_text("Inter-Regular.otf", 12.5f);
  fonts.mono = loader.add("DejaVuSansMono.ttf", 14, mono_ranges);
  loader.build();
  return fonts;
}

}  // namespace sectile::viewer
