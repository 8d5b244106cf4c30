#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cstdlib>

#include "app/icons.h"
#include "app/interface_input.h"
#include "app/panels/panels.h"
#include "app/words.h"

namespace sectile::viewer {
namespace {

const char* heading_of(FileBrowser::Purpose purpose) {
  switch (purpose) {
    case FileBrowser::Purpose::open:
      return "Open a scene or a mesh";
    case FileBrowser::Purpose::save:
      return "Save the scene";
    case FileBrowser::Purpose::import:
      return "Import a mesh";
    case FileBrowser::Purpose::export_solid:
      return "Export the result";
    case FileBrowser::Purpose::export_all:
      return "Export all solids (3MF: one file; else one each)";
    case FileBrowser::Purpose::picture:
      return "Save the picture";
    case FileBrowser::Purpose::film:
      return "Save the film";
  }
  return "";
}

const char* verb_of(FileBrowser::Purpose purpose) {
  switch (purpose) {
    case FileBrowser::Purpose::open:
      return "Open";
    case FileBrowser::Purpose::save:
      return "Save";
    case FileBrowser::Purpose::import:
      return "Import";
    case FileBrowser::Purpose::export_solid:
      return "Export";
    case FileBrowser::Purpose::export_all:
      return "Export";
    case FileBrowser::Purpose::picture:
    case FileBrowser::Purpose::film:
      return "Save";
  }
  return "";
}

std::string size_of(std::uintmax_t bytes) {
  if (bytes < 1024) return std::to_string(bytes) + " B";
  if (bytes < 1024 * 1024) return std::to_string(bytes / 1024) + " KiB";
  return std::to_string(bytes / (1024 * 1024)) + " MiB";
}

void draw_way(PanelContext& context, FileBrowser& browser) {
  if (icon_button(context, "browser.up", "\u2191", "To the folder above"))
    browser.show(browser.folder.parent_path());
  ImGui::SameLine(0, 3);
  if (icon_button(context, "browser.home", icons::home, "To your own folder"))
    if (const char* home = std::getenv("HOME")) browser.show(home);
  ImGui::SameLine();
  std::string folder = browser.folder.string();
  // The end of a long path says more than its beginning.
  const float room = ImGui::GetContentRegionAvail().x;
  if (text_width(folder) > room) {
    std::size_t from = 0;
    while (from < folder.size() && text_width("\u2026" + folder.substr(from)) > room) ++from;
    folder = "\u2026" + folder.substr(from);
  }
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(folder.c_str());
}

/// True when a file was double clicked.
bool draw_entries(PanelContext& context, FileBrowser& browser) {
  bool accepted = false;
  const float below = 2 * ImGui::GetFrameHeightWithSpacing() + 44;
  ImGui::BeginChild("entries", {0, -below}, true);
  std::string enter;
  for (const FileBrowser::Entry& entry : browser.entries) {
    const std::string text =
        std::string(entry.is_folder ? icons::folder_open : icons::file) + "  " + entry.name;
    if (ImGui::Selectable((text + "##entry").c_str(), browser.name == entry.name,
                          ImGuiSelectableFlags_AllowDoubleClick)) {
      if (entry.is_folder) {
        enter = entry.name;
      } else {
        browser.name = entry.name;
        browser.asks_to_replace = false;
        accepted = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
      }
    }
    context.widgets.record_item("browser:" + entry.name);
    if (!entry.is_folder) {
      const std::string size = size_of(entry.size);
      ImGui::SameLine(ImGui::GetContentRegionMax().x - text_width(size));
      ImGui::TextDisabled("%s", size.c_str());
    }
  }
  if (browser.entries.empty()) note(context, "No files of this kind here.");
  ImGui::EndChild();
  if (!enter.empty()) browser.show(browser.folder / enter);
  return accepted;
}

}  // namespace

void draw_file_browser(PanelContext& context) {
  Dialogs& dialogs = context.session.interface.dialogs;
  FileBrowser& browser = dialogs.browser;
  constexpr const char* id = "###file browser";
  if (!dialogs.browsing) return;
  const std::string window = std::string(heading_of(browser.purpose)) + id;
  if (!ImGui::IsPopupOpen(window.c_str())) ImGui::OpenPopup(window.c_str());
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowSize({std::min(640.0f, screen.x - 40), std::min(520.0f, screen.y - 60)});
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  bool open = true;
  if (!ImGui::BeginPopupModal(
          window.c_str(), &open,
          ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings))
    return;
  context.widgets.record_window("panel.browser");
  draw_way(context, browser);
  bool accept = draw_entries(context, browser);
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  accept |= ImGui::InputTextWithHint("##name", "name of the file", &browser.name,
                                     ImGuiInputTextFlags_EnterReturnsTrue);
  context.widgets.record_item("browser.name");
  if (ImGui::IsItemEdited()) browser.asks_to_replace = false;
  const float text_top = ImGui::GetCursorPosY();
  if (!browser.problem.empty()) note(context, browser.problem);
  ImGui::SetCursorPosY(text_top + 36);
  ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - 2 * 110 - 7);
  const bool cancel = button(context, "browser.cancel", "Cancel", "", true, 110);
  ImGui::SameLine();
  accept |= button(context, "browser.accept",
                   browser.asks_to_replace ? "Replace" : verb_of(browser.purpose), "", true, 110);
  const bool escaped = interface_input::was_pressed(Key::escape);
  if (cancel || escaped || !open || (accept && browser.accept())) {
    dialogs.browsing = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace sectile::viewer
