// A cube that shows from where the scene is seen: a click on a side looks at it, a drag turns.
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "app/panels/panels.h"

namespace sectile::viewer {
namespace {

constexpr float size = 92, half_edge = 27;

struct CubeSide {
  const char* name;
  const char* text;
  const char* command;
  glm::dvec3 normal, right;  // `right` is where the text runs
};
const CubeSide sides[] = {
    {"view_cube.front", "Front", "view.front", {0, -1, 0}, {1, 0, 0}},
    {"view_cube.back", "Back", "view.back", {0, 1, 0}, {-1, 0, 0}},
    {"view_cube.right", "Right", "view.right", {1, 0, 0}, {0, 1, 0}},
    {"view_cube.left", "Left", "view.left", {-1, 0, 0}, {0, -1, 0}},
    {"view_cube.top", "Top", "view.top", {0, 0, 1}, {1, 0, 0}},
    {"view_cube.bottom", "Bottom", "view.bottom", {0, 0, -1}, {1, 0, 0}},
};

class Cube {
 public:
  Cube(PanelContext& context, ImVec2 middle)
      : context_(context), middle_(middle), camera_(context.session.view.camera) {}

  /// The side under the pointer; null if there is none.
  const CubeSide* side_at(ImVec2 p) const {
    for (const CubeSide& side : sides)
      if (is_seen(side) && holds(corners(side), p)) return &side;
    return nullptr;
  }

  void draw(const CubeSide* hovered) const {
    for (const CubeSide& side : sides)
      if (is_seen(side)) draw_side(side, &side == hovered);
  }

  void record() const {
    for (const CubeSide& side : sides) {
      if (!is_seen(side)) continue;
      const ImVec2 at = on_screen(side.normal);
      Widget widget;
      widget.rectangle = {at.x - 4, at.y - 4, 8, 8};
      widget.surface = true;
      context_.widgets.record(side.name, widget);
    }
  }

 private:
  ImVec2 on_screen(const glm::dvec3& p) const {
    const double x = glm::dot(p, camera_.right()), y = glm::dot(p, camera_.up());
    return {middle_.x + half_edge * static_cast<float>(x),
            middle_.y - half_edge * static_cast<float>(y)};
  }

  bool is_seen(const CubeSide& side) const {
    return glm::dot(side.normal, camera_.forward()) < -0.02;
  }

  std::array<ImVec2, 4> corners(const CubeSide& side) const {
    const glm::dvec3 up = glm::cross(side.normal, side.right);
    return {on_screen(side.normal - side.right - up), on_screen(side.normal + side.right - up),
            on_screen(side.normal + side.right + up), on_screen(side.normal - side.right + up)};
  }

  static bool holds(const std::array<ImVec2, 4>& quad, ImVec2 p) {
    bool left = false, right = false;
    for (std::size_t i = 0; i < 4; ++i) {
      const ImVec2 a = quad[i], b = quad[(i + 1) % 4];
      const float turn = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
      (turn > 0 ? left : right) = true;
    }
    return left != right;
  }

  void draw_side(const CubeSide& side, bool hovered) const {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::array<ImVec2, 4> quad = corners(side);
    ImVec4 colour = ImGui::GetStyleColorVec4(hovered ? ImGuiCol_HeaderHovered : ImGuiCol_WindowBg);
    const float light = 0.86f + 0.14f * static_cast<float>(side.normal.z);
    if (!hovered) colour = {colour.x * light, colour.y * light, colour.z * light, 0.92f};
    list.AddConvexPolyFilled(quad.data(), 4, ImGui::GetColorU32(colour));
    list.AddPolyline(quad.data(), 4, ImGui::GetColorU32(ImGuiCol_Border), ImDrawFlags_Closed, 1);
    draw_text(side, list);
  }

  /// The text lies in the side: its corners are moved there after it was laid out.
  void draw_text(const CubeSide& side, ImDrawList& list) const {
    const double facing = -glm::dot(side.normal, camera_.forward());
    if (facing < 0.3) return;
    const glm::dvec3 up = glm::cross(side.normal, side.right);
    const ImVec2 at = on_screen(side.normal), x = direction(side.right), y = direction(-up);
    ImFont* font = context_.fonts.small;
    ImGui::PushFont(font);
    const ImVec2 extent = ImGui::CalcTextSize(side.text);
    ImGui::PopFont();
    const float shrink = std::min(1.0f, 1.75f * half_edge / extent.x);
    const int first = list.VtxBuffer.Size;
    ImGui::PushFont(font);
    list.AddText({at.x - extent.x / 2, at.y - extent.y / 2}, ImGui::GetColorU32(ImGuiCol_Text),
                 side.text);
    ImGui::PopFont();
    for (int i = first; i < list.VtxBuffer.Size; ++i) {
      ImVec2& p = list.VtxBuffer[i].pos;
      const float u = shrink * (p.x - at.x), v = shrink * (p.y - at.y);
      p = {at.x + u * x.x + v * y.x, at.y + u * x.y + v * y.y};
    }
  }

  /// How one unit of the interface along a direction is seen.
  ImVec2 direction(const glm::dvec3& d) const {
    return {static_cast<float>(glm::dot(d, camera_.right())),
            -static_cast<float>(glm::dot(d, camera_.up()))};
  }

  PanelContext& context_;
  ImVec2 middle_;
  const Camera& camera_;
};

}  // namespace

void draw_view_cube(PanelContext& context) {
  Session& session = context.session;
  if (!session.view.cube) return;
  const Rectangle& picture = context.layout.picture;
  const float taken = session.interface.view_panel ? 254.0f : 0.0f;
  if (picture.width < 2 * size + taken || picture.height < 2 * size) return;
  ImGui::SetNextWindowPos({picture.x + picture.width - size - 4 - taken, picture.y + 4});
  ImGui::SetNextWindowSize({size, size});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::Begin("view cube", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground |
                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav |
                   ImGuiWindowFlags_NoBringToFrontOnFocus);
  ImGui::PopStyleVar();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("view_cube", {size, size});
  const Cube cube(context, {corner.x + size / 2, corner.y + size / 2});
  const ImGuiIO& io = ImGui::GetIO();
  const CubeSide* hovered = ImGui::IsItemHovered() ? cube.side_at(io.MousePos) : nullptr;
  const bool dragged = ImGui::IsItemActive() && ImGui::IsMouseDragging(0, 3);
  if (dragged) session.view.camera.orbit(-0.012 * io.MouseDelta.x, 0.012 * io.MouseDelta.y);
  const ImVec2 way = ImGui::GetMouseDragDelta(0, 0);
  if (ImGui::IsItemDeactivated() && hovered && std::hypot(way.x, way.y) < 4)
    context.commands.run(session, context.commands.get(hovered->command));
  cube.draw(hovered);
  cube.record();
  ImGui::End();
}

}  // namespace sectile::viewer
