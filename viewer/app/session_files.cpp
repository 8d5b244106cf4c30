// Opening, saving, importing, exporting.
#include <algorithm>
#include <cctype>

#include "app/samples_menu.h"
#include "app/session.h"
#include "scene/scene_file.h"

namespace sectile::viewer {
namespace {

bool is_scene_file(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == ".sectile" || extension == ".json";
}

}  // namespace

void Session::start(Scene scene, std::filesystem::path path) {
  document.start(std::move(scene), std::move(path));
  told_errors_.clear();
  mode_ = Mode::model;
  frame_next_ = true;
}

void Session::new_scene() {
  start({}, {});
}

void Session::open(const std::filesystem::path& path) {
  if (!is_scene_file(path)) return import(path);
  after_saving("Open " + path.filename().string(), [this, path] {
    try {
      start(read_scene(path).scene, path);
    } catch (const std::exception& error) {
      messages.error(error.what());
    }
  });
}

void Session::import(const std::filesystem::path& path) {
  importer_.start(path);
}

void Session::open_sample(const std::string& name) {
  start(sample_scene(name), {});
  const auto& titles = sample_titles();
  const auto found = std::find_if(titles.begin(), titles.end(),
                                  [&](const SampleTitle& t) { return t.name == name; });
  if (found != titles.end()) messages.tell(found->figure + ": " + found->title);
}

bool Session::save(const std::filesystem::path& path) {
  try {
    document.save(path);
  } catch (const std::exception& error) {
    messages.error(error.what());
    return false;
  }
  messages.tell("Saved as " + path.filename().string() + ".");
  return true;
}

void Session::export_solid(const std::filesystem::path& path) {
  NodeId id = selected();
  if (selection().size() > 1 || (id == 0 && scene().roots().size() != 1)) {
    messages.error("Select the one solid to export: the scene has several.");
    return;
  }
  if (id == 0) id = scene().roots().front();
  const Solid* exported = solid(id);
  if (!exported || exported->is_empty()) {
    messages.error("There is nothing to export: this solid is empty or could not be computed.");
    return;
  }
  try {
    write_mesh(path, exported->to_mesh());
    messages.tell("Exported to " + path.filename().string() + ".");
  } catch (const std::exception& error) {
    messages.error(error.what());
  }
}

void Session::take_imports(bool wait) {
  for (Importer::Outcome& outcome : importer_.take(wait)) {
    if (!outcome.mesh) {
      messages.error(outcome.error);
      continue;
    }
    const bool first = scene().size() == 0;
    NodeId added = 0;
    const bool done = change("Import", [&](Scene& changed) {
      Node node;
      node.name = outcome.path.stem().string();
      node.what = Imported{outcome.path, outcome.mesh};
      added = changed.add(std::move(node));
    });
    if (done) select(added);
    if (done && first) frame_next_ = true;
  }
}

void Session::offer_recovery(const std::filesystem::path& data_folder) {
  for (const LostWork& work : Recovery::find(data_folder)) {
    Question question;
    question.title = "Recover unsaved work";
    question.text =
        "A session ended without saving \"" + work.title + "\". Its scene was kept: open it?";
    question.answers = {{"question.recover", "Open it", [this, work] { recover(work); }},
                        {"question.discard", "Throw it away", [work] { Recovery::discard(work); }},
                        {"question.later", "Ask me later", [] {}}};
    dialogs.ask(std::move(question));
    return;  // one at a time: the others are offered at the next start
  }
}

void Session::recover(const LostWork& work) {
  try {
    Scene scene = Recovery::read(work).scene;
    start({}, {});
    document.commit("Recover", std::move(scene));
    frame_next_ = true;
    Recovery::discard(work);
  } catch (const std::exception& error) {
    messages.error(std::string("The unsaved work cannot be read: ") + error.what());
  }
}

}  // namespace sectile::viewer
