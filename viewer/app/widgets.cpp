#include "app/widgets.h"

#include <imgui.h>
#include <imgui_internal.h>

namespace sectile::viewer {
namespace {

bool is_floating(const ImGuiWindow& window) {
  for (const ImGuiWindow* w = &window; w; w = w->ParentWindow)
    if (w->Flags & (ImGuiWindowFlags_Popup | ImGuiWindowFlags_Tooltip | ImGuiWindowFlags_Modal))
      return true;
  return false;
}

}  // namespace

void Widgets::record_item(const std::string& name, bool enabled, float text_width) {
  const ImGuiWindow& window = *ImGui::GetCurrentWindowRead();
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  // Half a unit is less than what rounding to pixels moves.
  const bool outside =
      low.x < window.ClipRect.Min.x - 0.5f || low.y < window.ClipRect.Min.y - 0.5f ||
      high.x > window.ClipRect.Max.x + 0.5f || high.y > window.ClipRect.Max.y + 0.5f;
  Widget widget;
  widget.rectangle = {low.x, low.y, high.x - low.x, high.y - low.y};
  widget.clipped = outside || text_width > high.x - low.x + 0.5f;
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
  widgets_[name] = widget;
}

const Widget* Widgets::find(const std::string& name) const {
  const auto found = widgets_.find(name);
  return found == widgets_.end() ? nullptr : &found->second;
}

}  // namespace sectile::viewer
