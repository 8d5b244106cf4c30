#include "app/style.h"

#include <cmath>

namespace sectile::viewer {
namespace {

ImVec4 grey(float value, float alpha = 1) {
  return {value, value, value * 1.01f, alpha};
}

void set_distances(ImGuiStyle& style) {
  style.WindowPadding = {10, 8};
  style.FramePadding = {7, 4};
  style.ItemSpacing = {7, 5};
  style.ItemInnerSpacing = {6, 4};
  style.CellPadding = {5, 3};
  style.IndentSpacing = 16;
  style.ScrollbarSize = style.GrabMinSize = 12;
  style.WindowBorderSize = style.FrameBorderSize = style.PopupBorderSize = 1;
  style.WindowRounding = 0;
  style.ChildRounding = style.FrameRounding = style.GrabRounding = 4;
  style.PopupRounding = 5;
  style.ScrollbarRounding = 6;
  style.WindowTitleAlign = {0.5f, 0.5f};
  style.DisabledAlpha = 0.38f;
}

struct Greys {
  ImVec4 window, popup, frame, frame_hovered, button, button_hovered, border, text, faint, accent;
};

void set_colours(ImVec4* c, const Greys& g) {
  const auto tinted = [&](float alpha) {
    return ImVec4(g.accent.x, g.accent.y, g.accent.z, alpha);
  };
  c[ImGuiCol_Text] = g.text;
  c[ImGuiCol_TextDisabled] = g.faint;
  c[ImGuiCol_WindowBg] = g.window;
  c[ImGuiCol_ChildBg] = {0, 0, 0, 0};
  c[ImGuiCol_PopupBg] = g.popup;
  c[ImGuiCol_MenuBarBg] = g.window;
  c[ImGuiCol_Border] = g.border;
  c[ImGuiCol_BorderShadow] = {0, 0, 0, 0};
  c[ImGuiCol_FrameBg] = g.frame;
  c[ImGuiCol_FrameBgHovered] = g.frame_hovered;
  c[ImGuiCol_FrameBgActive] = g.frame_hovered;
  c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = c[ImGuiCol_TitleBgCollapsed] = g.button;
  c[ImGuiCol_ScrollbarBg] = {0, 0, 0, 0};
  c[ImGuiCol_ScrollbarGrab] = g.border;
  c[ImGuiCol_ScrollbarGrabHovered] = c[ImGuiCol_ScrollbarGrabActive] = g.faint;
  c[ImGuiCol_CheckMark] = g.accent;
  c[ImGuiCol_SliderGrab] = tinted(0.85f);
  c[ImGuiCol_SliderGrabActive] = g.accent;
  c[ImGuiCol_Button] = g.button;
  c[ImGuiCol_ButtonHovered] = g.button_hovered;
  c[ImGuiCol_ButtonActive] = tinted(0.45f);
  c[ImGuiCol_Header] = tinted(0.25f);
  c[ImGuiCol_HeaderHovered] = tinted(0.18f);
  c[ImGuiCol_HeaderActive] = tinted(0.35f);
  c[ImGuiCol_Separator] = c[ImGuiCol_TableBorderStrong] = c[ImGuiCol_TableBorderLight] = g.border;
  c[ImGuiCol_TableHeaderBg] = g.button;
  c[ImGuiCol_TableRowBgAlt] = tinted(0.05f);
  c[ImGuiCol_PlotHistogram] = g.accent;
  c[ImGuiCol_TextSelectedBg] = tinted(0.35f);
  c[ImGuiCol_DragDropTarget] = g.accent;
  c[ImGuiCol_NavHighlight] = g.accent;
  c[ImGuiCol_ModalWindowDimBg] = {0, 0, 0, 0.35f};
}

}  // namespace

void apply_style(bool dark) {
  ImGuiStyle& style = ImGui::GetStyle();
  set_distances(style);
  if (dark) {
    ImGui::StyleColorsDark(&style);
    set_colours(style.Colors, {grey(0.155f),
                               grey(0.18f),
                               grey(0.11f),
                               grey(0.22f),
                               grey(0.235f),
                               grey(0.31f),
                               grey(0.31f),
                               grey(0.90f),
                               grey(0.60f),
                               {0.33f, 0.62f, 0.95f, 1}});
  } else {
    ImGui::StyleColorsLight(&style);
    set_colours(style.Colors, {grey(0.955f),
                               grey(0.985f),
                               grey(1.0f),
                               grey(0.97f),
                               grey(0.905f),
                               grey(0.855f),
                               grey(0.78f),
                               grey(0.12f),
                               grey(0.45f),
                               {0.10f, 0.42f, 0.78f, 1}});
  }
}

ImVec4 vector(const Colour& colour) {
  return {colour.r, colour.g, colour.b, colour.a};
}

ImU32 packed(const Colour& colour) {
  return ImGui::ColorConvertFloat4ToU32(vector(colour));
}

}  // namespace sectile::viewer
