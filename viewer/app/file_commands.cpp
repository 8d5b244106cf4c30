// The commands that read and write files.
#include "app/command_lists.h"
#include "app/icons.h"

namespace sectile::viewer {
namespace {

bool has_solids(const Document& d) {
  return d.scene().size() > 0;
}

void save_as(Session& s) {
  const std::string name =
      s.document.path().empty() ? "scene.sectile" : s.document.path().filename().string();
  s.interface.dialogs.browse(FileBrowser::Purpose::save, name,
                             [&s](const std::filesystem::path& path) { s.save(path); });
}

void save(Session& s) {
  if (s.document.path().empty()) return save_as(s);
  s.save(s.document.path());
}

void open(Session& s) {
  s.interface.dialogs.browse(FileBrowser::Purpose::open, "",
                             [&s](const std::filesystem::path& path) { s.open(path); });
}

void import(Session& s) {
  s.interface.dialogs.browse(FileBrowser::Purpose::import, "",
                             [&s](const std::filesystem::path& path) { s.import(path); });
}

void export_solid(Session& s) {
  s.interface.dialogs.browse(FileBrowser::Purpose::export_solid, "result.obj",
                             [&s](const std::filesystem::path& path) { s.export_solid(path); });
}

void export_all(Session& s) {
  s.interface.dialogs.browse(FileBrowser::Purpose::export_all, "parts.3mf",
                             [&s](const std::filesystem::path& path) { s.export_all(path); });
}

}  // namespace

std::vector<Command> file_commands() {
  return {
      {"file.new",
       "New",
       "Starts an empty scene.",
       icons::file,
       {{'N', true}},
       [](Session& s) { s.after_saving("New scene", [&s] { s.new_scene(); }); }},
      {"file.open",
       "Open\u2026",
       "Opens a scene, or adds a mesh to this one.",
       icons::folder_open,
       {{'O', true}},
       open},
      {"file.save", "Save", "Saves the scene.", icons::save, {{'S', true}}, save},
      {"file.save_as",
       "Save as\u2026",
       "Saves the scene under another name.",
       "",
       {{'S', true, true}},
       save_as},
      Command{"file.import",
              "Import mesh\u2026",
              "Adds the solid of an OBJ, STL, OFF, PLY or 3MF file.",
              icons::download,
              {{'I', true}},
              import}
          .after_line(),
      {"file.export",
       "Export result\u2026",
       "Writes the selected solid as OBJ, STL, OFF, PLY or 3MF.",
       icons::upload,
       {{'E', true}},
       export_solid,
       has_solids},
      {"file.export_all",
       "Export all solids\u2026",
       "Writes every solid that is shown: into one 3MF file, or each into a file of its own.",
       "",
       {{'E', true, true}},
       export_all,
       has_solids},
      {"file.record",
       "Save picture or film\u2026",
       "The picture at any size; a turntable or the steps as an animated GIF or as frames.",
       "",
       {{Key::f12}},
       [](InterfaceState& i) { i.dialogs.recording = true; }},
      Command{
          "file.quit",
          "Quit",
          "Closes the program.",
          "",
          {{'Q', true}},
          [](Session& s) { s.after_saving("Quit", [&s] { s.interface.wants_to_close = true; }); }}
          .after_line(),
  };
}

}  // namespace sectile::viewer
