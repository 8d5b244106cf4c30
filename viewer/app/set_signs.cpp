#include "app/set_signs.h"

#include <algorithm>
#include <cmath>

namespace sectile::viewer {
namespace {

// A sign is drawn in a box of height 1; y goes downwards. What covers a point: 0 … 1.
using Coverage = float (*)(float x, float y);

struct Sign {
  ImWchar code;
  float width;
  Coverage coverage;
};

constexpr float filled = 0.62f;

struct Venn {
  static constexpr float radius = 0.385f, left = 0.45f, right = 0.90f, line = 0.055f;
  bool in_a, in_b, on_line;

  Venn(float x, float y) {
    const float a = std::hypot(x - left, y - 0.5f), b = std::hypot(x - right, y - 0.5f);
    in_a = a < radius;
    in_b = b < radius;
    on_line = std::abs(a - radius) < line || std::abs(b - radius) < line;
  }
  float with(bool inside) const { return on_line ? 1 : inside ? filled : 0; }
};

float venn_union(float x, float y) {
  const Venn v(x, y);
  return v.with(v.in_a || v.in_b);
}
float venn_intersection(float x, float y) {
  const Venn v(x, y);
  return v.with(v.in_a && v.in_b);
}
float venn_difference(float x, float y) {
  const Venn v(x, y);
  return v.with(v.in_a && !v.in_b);
}

// A horseshoe, wider than it is high and of one thickness: neither u nor U.
float cup(float x, float y) {
  constexpr float middle = 0.46f, outer = 0.39f, inner = 0.29f, top = 0.16f, bend = 0.45f;
  if (y < top) return 0;
  const float across = std::abs(x - middle);
  const float away = y < bend ? across : std::hypot(across, y - bend);
  return away < outer && away > inner ? 1 : 0;
}
float cap(float x, float y) {
  return cup(x, 1 - y);
}

constexpr Sign signs[] = {{0xe001, 1.35f, venn_union},
                          {0xe002, 1.35f, venn_intersection},
                          {0xe003, 1.35f, venn_difference},
                          {0x222a, 0.92f, cup},
                          {0x2229, 0.92f, cap}};

const Sign& sign_of(ImWchar code) {
  return *std::find_if(std::begin(signs), std::end(signs),
                       [code](const Sign& sign) { return sign.code == code; });
}

float mean_coverage(const Sign& sign, int x, int y, int height) {
  constexpr int pieces = 5;
  float sum = 0;
  for (int i = 0; i < pieces * pieces; ++i) {
    const float u = static_cast<float>(x) + (static_cast<float>(i % pieces) + 0.5f) / pieces;
    const float v = static_cast<float>(y) + (static_cast<float>(i / pieces) + 0.5f) / pieces;
    sum += sign.coverage(u / static_cast<float>(height), v / static_cast<float>(height));
  }
  return sum / (pieces * pieces);
}

}  // namespace

void SetSigns::add_to(ImFontAtlas& atlas, ImFont* font, float size) {
  for (const Sign& sign : signs) {
    // As high as capitals with a little more, on the line that letters stand on.
    const int height = static_cast<int>(std::lround(0.86f * size));
    const int width = static_cast<int>(std::ceil(sign.width * static_cast<float>(height)));
    const ImVec2 offset{0, std::round(0.08f * size)};
    places_.push_back({atlas.AddCustomRectFontGlyph(font, sign.code, width, height,
                                                    static_cast<float>(width), offset),
                       sign.code});
  }
}

void SetSigns::draw(ImFontAtlas& atlas) const {
  unsigned char* pixels = nullptr;
  int row = 0, rows = 0;
  atlas.GetTexDataAsAlpha8(&pixels, &row, &rows);
  for (const Place& place : places_) {
    const ImFontAtlasCustomRect& room = *atlas.GetCustomRectByIndex(place.rectangle);
    const Sign& sign = sign_of(place.code);
    for (int y = 0; y < room.Height; ++y)
      for (int x = 0; x < room.Width; ++x)
        pixels[(room.Y + y) * row + room.X + x] =
            static_cast<unsigned char>(255 * mean_coverage(sign, x, y, room.Height));
  }
}

}  // namespace sectile::viewer
