// The drawing area of the profile dialog.
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "app/panels/panels.h"
#include "app/words.h"

namespace sectile::viewer {
namespace {

constexpr float reach = 8;
using Corner = ProfileSketch::Corner;

/// The drawing area: a view of the plane, and what the mouse does in it.
class Canvas {
 public:
  Canvas(PanelContext& context, ImVec2 size)
      : context_(context),
        editor_(context.session.interface.profile),
        low_(ImGui::GetCursorScreenPos()) {
    size_ = size;
    ImGui::InvisibleButton("canvas", size,
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    if (editor_.fit) fit();
  }

  void react() {
    const ImGuiIO& io = ImGui::GetIO();
    const bool hovered = ImGui::IsItemHovered();
    if (hovered && io.MouseWheel != 0) zoom(std::pow(0.88, static_cast<double>(io.MouseWheel)));
    if (ImGui::IsItemActive() && (io.MouseDown[1] || io.MouseDown[2])) {
      editor_.centre.x -= io.MouseDelta.x * unit();
      editor_.centre.y += io.MouseDelta.y * unit();
    }
    place_ = snapped_place(to_plane(io.MousePos));
    hovered_ = hovered;
    if (hovered && ImGui::IsMouseClicked(0)) press();
    if (ImGui::IsItemActive() && io.MouseDown[0] && dragging() &&
        (io.MouseDelta.x != 0 || io.MouseDelta.y != 0))
      editor_.sketch.move(*editor_.selected, place_);
    if (ImGui::IsMouseReleased(0)) editor_.sketch.end_move(), editor_.dragging = false;
  }

  void draw() {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(low_, {low_.x + size_.x, low_.y + size_.y}, true);
    list.AddRectFilled(low_, {low_.x + size_.x, low_.y + size_.y},
                       ImGui::GetColorU32(ImGuiCol_FrameBg));
    draw_grid(list);
    draw_guides(list);
    for (std::size_t i = 0; i < editor_.sketch.loops().size(); ++i) draw_loop(list, i);
    draw_drawn(list);
    draw_side_numbers(list);
    draw_scale(list);
    list.PopClipRect();
    record();
  }

 private:
  double unit() const { return editor_.units_across / size_.x; }
  ImVec2 on_screen(const Vec2& p) const {
    return {low_.x + size_.x / 2 + static_cast<float>((p.x - editor_.centre.x) / unit()),
            low_.y + size_.y / 2 - static_cast<float>((p.y - editor_.centre.y) / unit())};
  }
  Vec2 to_plane(ImVec2 p) const {
    return {editor_.centre.x + (p.x - low_.x - size_.x / 2) * unit(),
            editor_.centre.y - (p.y - low_.y - size_.y / 2) * unit()};
  }

  void fit() {
    editor_.fit = false;
    Bounds box;
    const auto add = [&](const Vec2& p) { box.add(glm::dvec3(p.x, p.y, 0)); };
    for (const Loop& loop : editor_.sketch.loops()) std::for_each(loop.begin(), loop.end(), add);
    std::for_each(editor_.guides.begin(), editor_.guides.end(), add);
    if (box.is_empty()) add({-3, -3}), add({3, 3});
    editor_.centre = {box.centre().x, box.centre().y};
    const double wide = box.high.x - box.low.x, high = box.high.y - box.low.y;
    editor_.units_across = 1.3 * std::max({wide, high * size_.x / size_.y, 1e-6});
  }

  void zoom(double factor) {
    const Vec2 before = to_plane(ImGui::GetIO().MousePos);
    editor_.units_across = std::clamp(editor_.units_across * factor, 1e-4, 1e7);
    const Vec2 after = to_plane(ImGui::GetIO().MousePos);
    editor_.centre.x += before.x - after.x, editor_.centre.y += before.y - after.y;
  }

  double grid_step() const {
    const double least = 14 * unit(), decade = std::pow(10, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.5, 5.0})
      if (factor * decade >= least) return factor * decade;
    return 10 * decade;
  }

  /// Corners, ends of guides, then the grid; with Ctrl the place itself.
  Vec2 snapped_place(const Vec2& p) const {
    if (ImGui::GetIO().KeyCtrl) return p;
    const ImVec2 at = on_screen(p);
    const auto is_near = [&](const Vec2& q) {
      const ImVec2 seen = on_screen(q);
      return std::hypot(seen.x - at.x, seen.y - at.y) <= reach;
    };
    for (const Vec2& q : editor_.guides)
      if (is_near(q)) return q;
    for (const Vec2& q : editor_.sketch.drawn())
      if (is_near(q)) return q;
    const double step = grid_step();
    return {step * std::round(p.x / step), step * std::round(p.y / step)};
  }

  std::optional<Corner> corner_at(ImVec2 at) const {
    const auto& loops = editor_.sketch.loops();
    for (std::size_t l = 0; l < loops.size(); ++l)
      for (std::size_t c = 0; c < loops[l].size(); ++c) {
        const ImVec2 p = on_screen(loops[l][c]);
        if (std::hypot(p.x - at.x, p.y - at.y) <= reach) return Corner{l, c};
      }
    return std::nullopt;
  }

  /// The corner at the end of the side under a place.
  std::optional<Corner> side_at(ImVec2 at) const {
    const auto& loops = editor_.sketch.loops();
    for (std::size_t l = 0; l < loops.size(); ++l)
      for (std::size_t c = 0; c < loops[l].size(); ++c) {
        const ImVec2 a = on_screen(editor_.sketch.before({l, c})), b = on_screen(loops[l][c]);
        const ImVec2 p = ImLineClosestPoint(a, b, at);
        if (std::hypot(p.x - at.x, p.y - at.y) <= reach * 0.6f) return Corner{l, c};
      }
    return std::nullopt;
  }

  void press() {
    ProfileSketch& sketch = editor_.sketch;
    const ImVec2 at = ImGui::GetIO().MousePos;
    const Loop& drawn = sketch.drawn();
    if (!drawn.empty()) {
      const ImVec2 first = on_screen(drawn.front());
      if (drawn.size() >= 3 && std::hypot(first.x - at.x, first.y - at.y) <= reach)
        sketch.close();
      else
        sketch.add_corner(place_);
      return;
    }
    if ((editor_.selected = corner_at(at))) {
      editor_.dragging = true;
      return;
    }
    if (const auto side = side_at(at); side && ImGui::IsMouseDoubleClicked(0)) {
      sketch.insert_before(*side, place_);
      editor_.selected = side;
    } else if (side) {
      editor_.selected = side;
    } else {
      sketch.add_corner(place_);
    }
  }

  bool dragging() {
    if (!editor_.dragging || !editor_.selected || !ImGui::IsMouseDragging(0, 3)) return false;
    editor_.sketch.begin_move();
    return true;
  }

  void draw_grid(ImDrawList& list) const {
    const ImVec4 line = ImGui::GetStyleColorVec4(ImGuiCol_Border);
    const ImU32 thin = ImGui::GetColorU32(ImVec4(line.x, line.y, line.z, 0.35f));
    const ImU32 thick = ImGui::GetColorU32(ImVec4(line.x, line.y, line.z, 1.0f));
    const double step = grid_step();
    const Vec2 from = to_plane({low_.x, low_.y + size_.y}),
               to = to_plane({low_.x + size_.x, low_.y});
    for (double x = step * std::ceil(from.x / step); x <= to.x; x += step) {
      const float at = on_screen({x, 0}).x;
      list.AddLine({at, low_.y}, {at, low_.y + size_.y}, std::abs(x) < step / 2 ? thick : thin);
    }
    for (double y = step * std::ceil(from.y / step); y <= to.y; y += step) {
      const float at = on_screen({0, y}).y;
      list.AddLine({low_.x, at}, {low_.x + size_.x, at}, std::abs(y) < step / 2 ? thick : thin);
    }
    if (editor_.primitive.kind->profile == ProfileUse::turned) {
      const float at = on_screen({0, 0}).x;
      list.AddLine({at, low_.y}, {at, low_.y + size_.y}, packed(context_.theme.handle_z), 2);
    }
  }

  void draw_guides(ImDrawList& list) const {
    const ImU32 colour = packed(with_alpha(context_.theme.neutral, 1));
    for (std::size_t i = 0; i + 1 < editor_.guides.size(); i += 2)
      list.AddLine(on_screen(editor_.guides[i]), on_screen(editor_.guides[i + 1]), colour, 2);
  }

  void draw_loop(ImDrawList& list, std::size_t index) const {
    const Loop& loop = editor_.sketch.loops()[index];
    const ImU32 line = packed(with_alpha(context_.theme.a, 1));
    std::vector<ImVec2> corners;
    for (const Vec2& p : loop) corners.push_back(on_screen(p));
    list.AddPolyline(corners.data(), static_cast<int>(corners.size()), line, ImDrawFlags_Closed, 2);
    const bool few = corners.size() <= 64;
    for (std::size_t c = 0; c < corners.size(); ++c) {
      const bool selected = editor_.selected == Corner{index, c};
      if (few || selected)
        list.AddCircleFilled(corners[c], selected ? 6 : 4,
                             selected ? packed(context_.theme.step) : line);
    }
  }

  void draw_drawn(ImDrawList& list) const {
    const Loop& drawn = editor_.sketch.drawn();
    const ImU32 colour = packed(context_.theme.step);
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      list.AddCircleFilled(on_screen(drawn[i]), i == 0 ? 6 : 4, colour);
      if (i > 0) list.AddLine(on_screen(drawn[i - 1]), on_screen(drawn[i]), colour, 2);
    }
    if (!hovered_) return;
    const ImVec2 at = on_screen(place_);
    list.AddCircle(at, 5, colour);
    if (!drawn.empty()) list.AddLine(on_screen(drawn.back()), at, colour, 1);
  }

  /// Length and angle of the side under work.
  void draw_side_numbers(ImDrawList& list) const {
    const Loop& drawn = editor_.sketch.drawn();
    Vec2 from, to;
    if (!drawn.empty() && hovered_) {
      from = drawn.back(), to = place_;
    } else if (drawn.empty() && editor_.selected) {
      from = editor_.sketch.before(*editor_.selected), to = editor_.sketch.at(*editor_.selected);
    } else {
      return;
    }
    const SketchSide side = side_between(from, to);
    if (side.length == 0) return;
    const std::string text = number(side.length) + "  " + number(side.degrees) + "\u00B0";
    const ImVec2 at = on_screen({0.5 * (from.x + to.x), 0.5 * (from.y + to.y)});
    const ImVec2 extent = ImGui::CalcTextSize(text.c_str());
    list.AddRectFilled({at.x + 6, at.y - extent.y - 6}, {at.x + extent.x + 14, at.y - 2},
                       ImGui::GetColorU32(ImGuiCol_PopupBg, 0.9f), 3);
    list.AddText({at.x + 10, at.y - extent.y - 4}, ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
  }

  /// How far apart the lines of the grid are, and where the next corner would be.
  void draw_scale(ImDrawList& list) const {
    std::string text = "Grid " + number(grid_step());
    if (hovered_) text += "   x " + number(place_.x) + "   y " + number(place_.y);
    const ImVec2 extent = ImGui::CalcTextSize(text.c_str());
    const ImVec2 at{low_.x + 8, low_.y + size_.y - extent.y - 7};
    list.AddRectFilled({at.x - 4, at.y - 2}, {at.x + extent.x + 4, at.y + extent.y + 2},
                       ImGui::GetColorU32(ImGuiCol_PopupBg, 0.9f), 3);
    list.AddText(at, ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
    Widget widget;
    widget.rectangle = {at.x, at.y, extent.x, extent.y};
    widget.surface = widget.floating = true;
    context_.widgets.record("text:" + text, widget);
  }

  /// Two places of the plane, so that tests find all others, and the corners.
  void record() {
    const auto mark = [&](const std::string& name, const Vec2& p) {
      const ImVec2 at = on_screen(p);
      Widget widget;
      widget.rectangle = {at.x, at.y, 0, 0};
      widget.surface = widget.floating = true;
      context_.widgets.record(name, widget);
    };
    mark("profile.at.0.0", {0, 0});
    mark("profile.at.1.1", {1, 1});
  }

  PanelContext& context_;
  ProfileEditor& editor_;
  ImVec2 low_, size_;
  Vec2 place_;
  bool hovered_ = false;
};

}  // namespace

void draw_profile_canvas(PanelContext& context, float width, float height) {
  Canvas canvas(context, {width, height});
  canvas.react();
  canvas.draw();
}

}  // namespace sectile::viewer
