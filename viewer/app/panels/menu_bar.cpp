#include <imgui_internal.h>

#include <array>

#include "app/interface_input.h"
#include "app/panels/panels.h"
#include "app/samples_menu.h"
#include "app/words.h"

namespace sectile::viewer {
namespace {

/// A menu of commands; "-" stands for a line.
void command_menu(PanelContext& context, const char* name, const char* text,
                  std::initializer_list<const char*> items) {
  const bool open = ImGui::BeginMenu(text);
  context.widgets.record_item(name);
  if (!open) return;
  for (const char* item : items) {
    if (*item == '-')
      ImGui::Separator();
    else
      command_item(context, item);
  }
  ImGui::EndMenu();
}

void add_menu(PanelContext& context) {
  const bool open = ImGui::BeginMenu("Add");
  context.widgets.record_item("menu.add");
  if (!open) return;
  for (const Primitive::Shape shape : all_shapes) command_item(context, "add." + name_of(shape));
  ImGui::Separator();
  command_item(context, "file.import");
  ImGui::EndMenu();
}

void sample_item(PanelContext& context, const SampleTitle& sample) {
  const bool pressed =
      ImGui::MenuItem((sample.title + "##" + sample.name).c_str(), sample.figure.c_str());
  context.widgets.record_item("sample:" + sample.name);
  if (!pressed) return;
  Session& session = context.session;
  session.after_saving("Open a sample",
                       [&session, name = sample.name] { session.open_sample(name); });
}

void samples_menu(PanelContext& context) {
  const bool open = ImGui::BeginMenu("Samples");
  context.widgets.record_item("menu.samples");
  if (!open) return;
  for (const SampleTitle& sample : sample_titles()) sample_item(context, sample);
  ImGui::EndMenu();
}

/// Left and Right go from an open menu to the one beside it.
void walk_along_menus() {
  constexpr std::array menus{"File", "Edit", "Add", "Operations", "View", "Samples", "Help"};
  const int by = interface_input::was_pressed(Key::right)  ? 1
                 : interface_input::was_pressed(Key::left) ? -1
                                                           : 0;
  for (std::size_t i = 0; by != 0 && i < menus.size(); ++i) {
    if (!ImGui::IsPopupOpen(menus[i])) continue;
    // The mouse may still rest on the title of the menu before, which would open it again.
    ImGui::GetCurrentContext()->NavDisableMouseHover = true;
    return ImGui::OpenPopup(
        menus[(i + menus.size() + static_cast<std::size_t>(by)) % menus.size()]);
  }
}

}  // namespace

float draw_menu_bar(PanelContext& context) {
  if (!ImGui::BeginMainMenuBar()) return 0;
  const float height = ImGui::GetWindowHeight();
  context.widgets.record_window("panel.menu_bar");
  walk_along_menus();
  command_menu(context, "menu.file", "File",
               {"file.new", "file.open", "file.save", "file.save_as", "-", "file.import",
                "file.export", "-", "file.quit"});
  command_menu(context, "menu.edit", "Edit",
               {"edit.undo", "edit.redo", "-", "edit.duplicate", "edit.delete", "edit.rename",
                "edit.hide", "-", "edit.group", "edit.ungroup", "-", "edit.select_all"});
  add_menu(context);
  command_menu(context, "menu.operations", "Operations",
               {"operation.unite", "operation.intersect", "operation.subtract", "operation.split",
                "-", "mode.model", "mode.steps"});
  command_menu(
      context, "menu.view", "View",
      {"view.frame", "view.all", "view.front", "view.right", "view.top", "view.orthographic", "-",
       "view.wireframe", "view.hidden_lines", "view.labels", "view.eight_way", "view.section",
       "view.grid", "view.axes", "-", "view.dark", "view.panel"});
  samples_menu(context);
  command_menu(context, "menu.help", "Help", {"help.keys", "help.hints", "help.about"});
  ImGui::EndMainMenuBar();
  return height;
}

}  // namespace sectile::viewer
