// The edges between panels, to be dragged.
#include <algorithm>

#include "app/panels/panels.h"

namespace sectile::viewer {
namespace {

constexpr float thickness = 6;

/// A strip on an edge at `x`. `size` is that of the panel beside it, which grows as the mouse moves
/// by `sign` along x.
void draw_splitter(PanelContext& context, const char* name, float x, const Rectangle& beside,
                   float sign, double& size) {
  ImGui::SetNextWindowPos({x - thickness / 2, beside.y});
  ImGui::SetNextWindowSize({thickness, beside.height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::Begin(name, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  ImGui::PopStyleVar(2);
  ImGui::InvisibleButton(name, {thickness, std::max(1.0f, beside.height)});
  if (ImGui::IsItemHovered() || ImGui::IsItemActive())
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (ImGui::IsItemActive())
    size = std::max(1.0f, beside.width + sign * ImGui::GetIO().MouseDelta.x);
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) size = 0;
  context.widgets.record_window(name);
  ImGui::End();
}

}  // namespace

void draw_splitters(PanelContext& context) {
  ViewSettings& view = context.session.view;
  const bool steps = context.session.mode() == Mode::steps;
  const Layout& layout = context.layout;
  const float left = layout.tree.x + layout.tree.width;
  Rectangle whole_left = layout.tree;
  whole_left.height += layout.properties.height;
  draw_splitter(context, "splitter.left", left, whole_left, 1,
                steps ? view.left_steps : view.left_model);
  if (steps && layout.inspector.width > 0)
    draw_splitter(context, "splitter.right", layout.inspector.x, layout.inspector, -1,
                  view.right_steps);
}

}  // namespace sectile::viewer
