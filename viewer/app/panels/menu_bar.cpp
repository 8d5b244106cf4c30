#include <imgui_internal.h>

#include <string>
#include <vector>

#include "app/interface_input.h"
#include "app/panels/panels.h"
#include "app/samples_menu.h"
#include "app/words.h"

namespace sectile::viewer {
namespace {

/// A menu that knows where its title is: once it is open, ImGui's last item is another one.
bool begin_menu(PanelContext& context, const std::string& name, const std::string& text,
                bool enabled = true) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  Widget widget;
  widget.rectangle = {at.x, at.y, text_width(text), ImGui::GetTextLineHeight()};
  widget.floating = true;
  widget.enabled = enabled;
  context.widgets.record(name, widget);
  return ImGui::BeginMenu(text.c_str(), enabled);
}

/// `aside` becomes true if the keyboard's mark stands on it or beyond it: Left and Right are for
/// the way to the side then.
bool begin_submenu(PanelContext& context, const std::string& text, bool& aside,
                   bool enabled = true) {
  const bool marked = ImGui::GetFocusID() == ImGui::GetID(text.c_str());
  const bool open = begin_menu(context, "submenu." + text, text, enabled);
  aside |= open || (marked && enabled);
  return open;
}

void recent_files(PanelContext& context, bool& aside) {
  Session& session = context.session;
  const std::vector<std::filesystem::path> files = session.interface.recent.list();
  ImGui::Separator();
  if (!begin_submenu(context, "Recent files", aside, !files.empty())) return;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string folder = files[i].parent_path().string();
    if (ImGui::MenuItem((files[i].filename().string() + "##" + std::to_string(i)).c_str(),
                        folder.size() > 40 ? ("\u2026" + folder.substr(folder.size() - 39)).c_str()
                                           : folder.c_str()))
      session.open(files[i]);
    context.widgets.record_item("recent." + std::to_string(i));
  }
  ImGui::Separator();
  if (ImGui::MenuItem("Forget them")) session.interface.recent.clear();
  ImGui::EndMenu();
}

void draw_menu(PanelContext& context, const CommandMenu& menu, bool& aside) {
  if (!begin_menu(context, menu.name, menu.title)) return;
  std::string submenu;
  bool shown = true;
  const auto enter = [&](const std::string& wanted) {
    if (wanted == submenu) return;
    if (!submenu.empty() && shown) ImGui::EndMenu();
    submenu = wanted;
    shown = submenu.empty() || begin_submenu(context, submenu, aside);
  };
  for (const Command& command : menu.commands) {
    if (!command.in_menu) continue;
    enter(command.submenu);
    if (!shown) continue;
    if (command.begins_group) ImGui::Separator();
    command_item(context, command.name);
  }
  enter({});
  if (menu.name == "menu.file") recent_files(context, aside);
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
  if (!begin_menu(context, "menu.samples", "Samples")) return;
  for (const SampleTitle& sample : sample_titles()) sample_item(context, sample);
  ImGui::EndMenu();
}

/// The titles of the menu bar; samples stand before the help.
std::vector<std::string> menu_titles(const PanelContext& context) {
  std::vector<std::string> titles;
  for (const CommandMenu& menu : context.commands.menus()) titles.push_back(menu.title);
  titles.insert(titles.end() - 1, "Samples");
  return titles;
}

/// Left and Right go from an open menu to the one beside it.
void walk_along_menus(const std::vector<std::string>& titles) {
  const std::size_t count = titles.size();
  const std::size_t by = interface_input::was_pressed(Key::right)  ? 1
                         : interface_input::was_pressed(Key::left) ? count - 1
                                                                   : 0;
  for (std::size_t i = 0; by != 0 && i < count; ++i) {
    if (!ImGui::IsPopupOpen(titles[i].c_str())) continue;
    // The mouse may still rest on the title of the menu before, which would open it again; and
    // ImGui would take the key for a walk along the titles, which closes what is open.
    ImGui::GetCurrentContext()->NavDisableMouseHover = true;
    ImGui::NavMoveRequestCancel();
    return ImGui::OpenPopup(titles[(i + by) % count].c_str());
  }
}

}  // namespace

float draw_menu_bar(PanelContext& context) {
  if (!ImGui::BeginMainMenuBar()) return 0;
  const float height = ImGui::GetWindowHeight();
  context.widgets.record_window("panel.menu_bar");
  bool aside = false;
  for (const CommandMenu& menu : context.commands.menus()) {
    if (&menu == &context.commands.menus().back()) samples_menu(context);
    draw_menu(context, menu, aside);
  }
  if (!aside) walk_along_menus(menu_titles(context));
  ImGui::EndMainMenuBar();
  return height;
}

}  // namespace sectile::viewer
