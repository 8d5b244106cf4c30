// The neighborhood of a contact as arcs on the unit sphere, seen from where most of it is seen.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/panels/panels.h"
#include "app/sphere_inside.h"

namespace sectile::viewer {
namespace {

constexpr float shading_step = 10;  ///< between samples of a line

class SphereDrawing {
 public:
  SphereDrawing(const SpherePicture& picture, const std::string& lit_face, const Camera& camera,
                const Theme& theme, ImVec2 centre, float radius)
      : picture_(picture),
        lit_face_(lit_face),
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

  /// Tints what lies inside A and inside B on the half that faces the viewer, line by line.
  void shade() {
    for (const int solid : {0, 1})
      for (float y = 0.5f - std::floor(radius_); y < radius_; y += 1) shade_line(solid, y);
  }

  bool is_inside_at(int solid, float x, float y) const {
    const float u = x / radius_, v = y / radius_;
    const float rest = std::max(0.0f, 1 - u * u - v * v);
    return is_inside(picture_, solid, u * right_ + v * up_ + std::sqrt(rest) * towards_);
  }

  void shade_line(int solid, float y) {
    const ImU32 tint = packed(with_alpha(colour_of(solid), 0.27f));
    const float half = std::sqrt(radius_ * radius_ - y * y);
    const int samples = std::max(2, static_cast<int>(std::ceil(half / shading_step)));
    const float step = 2 * half / static_cast<float>(samples);
    // Not on the rim itself, where both halves of the sphere meet.
    float start = -half, last = -half + step / 8;
    bool inside = is_inside_at(solid, last, y);
    for (int i = 1; i <= samples; ++i) {
      const bool at_end = i == samples;
      const float x = at_end ? half - step / 8 : -half + step * static_cast<float>(i);
      const bool now = is_inside_at(solid, x, y);
      const float change = now == inside ? x : between(solid, last, x, y, inside);
      if (inside && (now != inside || at_end)) fill(start, now != inside ? change : half, y, tint);
      if (now != inside) start = change;
      if (at_end && now && !inside) fill(start, half, y, tint);
      inside = now;
      last = x;
    }
  }

  // Where a line leaves or enters a solid.
  float between(int solid, float low, float high, float y, bool inside_at_low) const {
    for (int i = 0; i < 6; ++i) {
      const float middle = (low + high) / 2;
      (is_inside_at(solid, middle, y) == inside_at_low ? low : high) = middle;
    }
    return (low + high) / 2;
  }

  void fill(float from, float to, float y, ImU32 tint) {
    draw_.AddRectFilled({centre_.x + from, centre_.y - y - 0.5f},
                        {centre_.x + to, centre_.y - y + 0.5f}, tint);
  }

  void draw_arc(const SpherePicture::Arc& arc, bool front) {
    const std::vector<glm::vec3> points = points_of(arc);
    const bool lit = !lit_face_.empty() && arc.label == lit_face_;
    const Colour& own = lit ? theme_.step : colour_of(arc.solid);
    const ImU32 colour = packed(with_alpha(own, front ? 1.0f : lit ? 0.6f : 0.30f));
    const float width = (front ? 2.6f : 1.2f) + (lit ? 3.0f : 0.0f);
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
    if (mark.cut) text += text.empty() ? "cut" : " cut";
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
  const std::string& lit_face_;
  const Theme& theme_;
  ImVec2 centre_;
  float radius_;
  glm::vec3 right_, up_, towards_;
  ImDrawList& draw_;
  std::vector<ImVec4> taken_;
};

/// The direction from which most is seen: contact segments count most, then edges, then faces.
glm::dvec3 interesting_side(const SpherePicture& picture, const glm::dvec3& otherwise) {
  glm::dvec3 sum(0);
  for (const SpherePicture::Mark& mark : picture.marks)
    sum += (mark.solid < 0 ? 2.0 : 0.5) * glm::dvec3(mark.direction);
  for (const SpherePicture::Arc& arc : picture.arcs) {
    const glm::dvec3 middle(arc.from + arc.to);
    if (glm::length(middle) > 1e-6) sum += 0.25 * glm::normalize(middle);
  }
  // What lies opposite to each other is seen from neither end.
  if (glm::length(sum) < 0.3) return otherwise;
  return glm::normalize(glm::normalize(sum) + 0.35 * otherwise);
}

void turn_to(SphereTurn& turn, const Session& session, const SpherePicture& picture) {
  const auto story = session.results.player.shared();
  if (turn.story == story && turn.step == session.results.player.step()) return;
  turn.story = story;
  turn.step = session.results.player.step();
  const glm::dvec3 from = interesting_side(picture, -session.view.camera.forward());
  turn.camera.azimuth = std::atan2(from.y, from.x);
  turn.camera.elevation = std::clamp(std::asin(std::clamp(from.z, -1.0, 1.0)), -1.4, 1.4);
}

std::string caption_of(const Step& step, bool dark) {
  std::string text = "All around the place: blue A, orange B, tinted inside. ";
  const auto segments = std::count_if(step.sphere.marks.begin(), step.sphere.marks.end(),
                                      [](const SpherePicture::Mark& m) { return m.solid < 0; });
  if (segments > 0) text += std::string(dark ? "White" : "Black") + ": contact segments.";
  return text;
}

}  // namespace

void draw_sphere(PanelContext& context, const Step& step, float width, float height) {
  Session& session = context.session;
  turn_to(session.view.sphere_turn, session, step.sphere);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushFont(context.fonts.small);
  const std::string caption = caption_of(step, session.view.dark);
  const float caption_height = ImGui::CalcTextSize(caption.c_str(), nullptr, false, width).y + 4;
  height -= caption_height;
  ImGui::InvisibleButton("sphere", {width, std::max(1.0f, height)});
  context.widgets.record_item("inspector.sphere");
  if (ImGui::IsItemActive()) {
    const ImVec2 by = ImGui::GetIO().MouseDelta;
    session.view.sphere_turn.camera.orbit(-0.01 * static_cast<double>(by.x),
                                          0.01 * static_cast<double>(by.y));
  }
  tooltip("The neighborhoods on a small sphere around the place. Drag to turn it.");
  const std::size_t row = static_cast<std::size_t>(session.interface.lit_row);
  const std::string lit =
      session.interface.lit_row >= 0 && row < step.row_faces.size() ? step.row_faces[row] : "";
  const float line = ImGui::GetTextLineHeight();
  // On whole pixels, from the bottom, in steps of a few: the same picture wherever what is above it
  // ends.
  const float most = std::max(10.0f, std::min(width, height - line) / 2 - 6);
  const float radius = most < 16 ? std::floor(most) : 4 * std::floor(most / 4);
  const ImVec2 centre(std::floor(at.x + width / 2),
                      std::floor(at.y + height - line / 2) - 6 - radius);
  SphereDrawing(step.sphere, lit, session.view.sphere_turn.camera, context.theme, centre, radius)
      .draw();
  ImGui::PushTextWrapPos(0);
  ImGui::TextDisabled("%s", caption.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopFont();
}

}  // namespace sectile::viewer
