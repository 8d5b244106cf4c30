// The neighborhood of a contact as arcs on the unit sphere, seen from where the camera is.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/panels/panels.h"
#include "app/sphere_inside.h"

namespace sectile::viewer {
namespace {

constexpr int shading_steps = 44;  ///< squares across the disc

class SphereDrawing {
 public:
  SphereDrawing(const SpherePicture& picture, const Camera& camera, const Theme& theme,
                ImVec2 centre, float radius)
      : picture_(picture),
        theme_(theme),
        centre_(centre),
        radius_(radius),
        right_(camera.right()),
        up_(camera.up()),
        towards_(-camera.forward()),
        draw_(*ImGui::GetWindowDrawList()) {}

  void draw() {
    const ImU32 rim = ImGui::GetColorU32(ImGuiCol_TextDisabled);
    draw_.AddCircleFilled(centre_, radius_, ImGui::GetColorU32(ImGuiCol_FrameBg), 96);
    shade();
    for (const bool front : {false, true}) {
      for (const SpherePicture::Arc& arc : picture_.arcs) draw_arc(arc, front);
      for (const SpherePicture::Mark& mark : picture_.marks) draw_mark(mark, front);
    }
    draw_.AddCircle(centre_, radius_, rim, 96, 1.2f);
    for (const SpherePicture::Mark& mark : picture_.marks) draw_mark_label(mark);
  }

 private:
  ImVec2 place(const glm::vec3& d) const {
    return {centre_.x + radius_ * glm::dot(d, right_), centre_.y - radius_ * glm::dot(d, up_)};
  }
  bool is_front(const glm::vec3& d) const { return glm::dot(d, towards_) >= 0; }
  Colour colour_of(int solid) const { return with_alpha(solid == 0 ? theme_.a : theme_.b, 1); }

  /// Tints what lies inside A and inside B on the half that faces the viewer.
  void shade() {
    const float side = 2 * radius_ / shading_steps;
    for (int row = 0; row < shading_steps; ++row)
      for (int column = 0; column < shading_steps; ++column) {
        const float x = (static_cast<float>(column) + 0.5f) * 2 / shading_steps - 1;
        const float y = 1 - (static_cast<float>(row) + 0.5f) * 2 / shading_steps;
        const float rest = 1 - x * x - y * y;
        if (rest < 0.01f) continue;
        const glm::vec3 d = x * right_ + y * up_ + std::sqrt(rest) * towards_;
        const ImVec2 low{centre_.x + (x * radius_ - side / 2),
                         centre_.y - (y * radius_ + side / 2)};
        for (const int solid : {0, 1})
          if (is_inside(picture_, solid, d))
            draw_.AddRectFilled(low, {low.x + side, low.y + side},
                                packed(with_alpha(colour_of(solid), 0.27f)));
      }
  }

  void draw_arc(const SpherePicture::Arc& arc, bool front) {
    const std::vector<glm::vec3> points = points_of(arc);
    const ImU32 colour = packed(with_alpha(colour_of(arc.solid), front ? 1.0f : 0.30f));
    const float width = front ? 2.6f : 1.2f;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      if (is_front(0.5f * (points[i] + points[i + 1])) == front)
        draw_.AddLine(place(points[i]), place(points[i + 1]), colour, width);
  }

  void draw_mark(const SpherePicture::Mark& mark, bool front) {
    if (is_front(mark.direction) != front) return;
    const ImVec2 at = place(mark.direction);
    const Colour colour =
        mark.solid == 0 || mark.solid == 1 ? colour_of(mark.solid) : theme_.coincident;
    draw_.AddCircleFilled(at, front ? 4.5f : 3, packed(with_alpha(colour, front ? 1.0f : 0.35f)));
    if (front) draw_.AddCircle(at, 4.5f, ImGui::GetColorU32(ImGuiCol_WindowBg), 0, 1);
  }

  void draw_mark_label(const SpherePicture::Mark& mark) {
    if (!is_front(mark.direction)) return;
    std::string text = mark.label;
    if (!mark.code.empty()) text += (text.empty() ? "" : " ") + mark.code;
    if (text.empty()) return;
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const ImVec2 at = place(mark.direction);
    // To the side that leads away from the middle, and inside the window.
    float x = at.x >= centre_.x ? at.x + 7 : at.x - 7 - size.x;
    const float left = ImGui::GetWindowPos().x + 4;
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowSize().x - 4 - size.x;
    x = std::clamp(x, left, std::max(left, right));
    float y = at.y - size.y / 2;
    for (const ImVec4& taken : taken_)
      if (x < taken.z && x + size.x > taken.x && y < taken.w && y + size.y > taken.y)
        y = at.y < centre_.y ? taken.y - size.y : taken.w;
    taken_.push_back({x, y, x + size.x, y + size.y});
    draw_.AddRectFilled({x - 2, y}, {x + size.x + 2, y + size.y},
                        ImGui::GetColorU32(ImGuiCol_WindowBg, 0.75f), 2);
    draw_.AddText({x, y}, ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
  }

  const SpherePicture& picture_;
  const Theme& theme_;
  ImVec2 centre_;
  float radius_;
  glm::vec3 right_, up_, towards_;
  ImDrawList& draw_;
  std::vector<ImVec4> taken_;
};

}  // namespace

void draw_sphere(PanelContext& context, const SpherePicture& picture, float width, float height) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("sphere", {width, height});
  context.widgets.record_item("inspector.sphere");
  if (ImGui::IsItemActive()) {
    const ImVec2 by = ImGui::GetIO().MouseDelta;
    context.session.camera.orbit(-0.01 * static_cast<double>(by.x),
                                 0.01 * static_cast<double>(by.y));
  }
  tooltip(
      "The neighborhoods on a small sphere around the place: blue is A, orange is B; tinted is "
      "inside. Seen as in the picture; drag to turn both.");
  const float line = ImGui::GetTextLineHeight();
  const float radius = std::max(10.0f, std::min(width, height - line) / 2 - 12);
  ImGui::PushFont(context.fonts.small);
  SphereDrawing(picture, context.session.camera, context.theme,
                {at.x + width / 2, at.y + height / 2}, radius)
      .draw();
  ImGui::PopFont();
}

}  // namespace sectile::viewer
