#include "app/widgets.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>

namespace sectile::viewer {
namespace {

bool is_floating(const ImGuiWindow& window) {
  for (const ImGuiWindow* w = &window; w; w = w->ParentWindow)
    if (w->Flags & (ImGuiWindowFlags_Popup | ImGuiWindowFlags_Tooltip | ImGuiWindowFlags_Modal))
      return true;
  return false;
}

/// Does a panel around it scroll?
bool scrolls_above(const ImGuiWindow& window) {
  for (const ImGuiWindow* w = window.ParentWindow; w; w = w->ParentWindow)
    if (w->ScrollMax.y > 0) return true;
  return false;
}

}  // namespace

void Widgets::record(const std::string& name, Widget widget) {
  widget.seen = widget.rectangle;
  widgets_[name] = widget;
}

void Widgets::record_text(const std::string& text) {
  record_item("text:" + text.substr(0, 32));
}

void Widgets::record_item(const std::string& name, bool enabled, float text_width) {
  const ImGuiWindow& window = *ImGui::GetCurrentWindowRead();
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  // Half a unit is less than what rounding to pixels moves.
  const ImRect& room = window.ClipRect;
  const bool outside = low.x < room.Min.x - 0.5f || high.x > room.Max.x + 0.5f;
  const bool beyond = low.y < room.Min.y - 0.5f || high.y > room.Max.y + 0.5f;
  const bool scrolls = window.ScrollMax.y > 0 || scrolls_above(window);
  Widget widget;
  widget.rectangle = {low.x, low.y, high.x - low.x, high.y - low.y};
  const float top = std::max(low.y, room.Min.y), bottom = std::min(high.y, room.Max.y);
  widget.seen = {low.x, top, high.x - low.x, std::max(0.0f, bottom - top)};
  widget.clipped = outside || (beyond && !scrolls) || text_width > high.x - low.x + 0.5f;
  widget.floating = is_floating(window);
  widget.enabled = enabled;
  widgets_[name] = widget;
}

void Widgets::record_surface(const std::string& name) {
  record_item(name);
  widgets_[name].surface = true;
}

void Widgets::record_window(const std::string& name) {
  const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  Widget widget;
  widget.rectangle = {low.x, low.y, size.x, size.y};
  widget.surface = true;
  widget.floating = is_floating(*ImGui::GetCurrentWindowRead());
  record(name, widget);
}

const Widget* Widgets::find(const std::string& name) const {
  const auto found = widgets_.find(name);
  return found == widgets_.end() ? nullptr : &found->second;
}

}  // namespace sectile::viewer
