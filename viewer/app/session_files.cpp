// Opening, saving, importing, exporting.
#include <algorithm>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "app/samples_menu.h"
#include "app/session.h"
#include "app/words.h"
#include "scene/scene_file.h"
#include "sectile/sectile.h"

namespace sectile::viewer {
namespace {

// "/home/me/a.ply:3: no faces" says what is wrong, but not as people say it.
std::string about_file(const std::string& error) {
  const std::size_t colon = error.find(": ");
  if (colon == std::string::npos) return error;
  std::string place = error.substr(0, colon), line;
  const std::size_t mark = place.rfind(':');
  const bool has_line = mark != std::string::npos && mark + 1 < place.size() &&
                        place.find_first_not_of("0123456789", mark + 1) == std::string::npos;
  if (has_line) {
    line = "line " + place.substr(mark + 1) + ": ";
    place.resize(mark);
  }
  return std::filesystem::path(place).filename().string() + ": " + line + error.substr(colon + 2);
}

}  // namespace

void Session::start(Scene scene, std::filesystem::path path) {
  document.start(std::move(scene), std::move(path));
  results.forget_errors();
  // What was told of the scene before is not about this one.
  for (std::size_t i = interface.messages.shown().size(); i-- > 0;)
    if (!interface.messages.shown()[i].is_error) interface.messages.close(i);
  isolated_.clear();
  mode_ = Mode::model;
  frame_next_ = true;
}

void Session::new_scene() {
  start({}, {});
}

void Session::in_background(FileWork::Kind kind, std::string activity,
                            std::function<FileWork::Finish()> work) {
  files_.start(kind, std::move(activity), [this, work = std::move(work)]() -> FileWork::Finish {
    try {
      return work();
    } catch (const FileError& error) {
      return [this, text = about_file(error.what())] { interface.messages.error(text); };
    } catch (const std::exception& error) {
      return [this, text = std::string(error.what())] { interface.messages.error(text); };
    }
  });
}

void Session::open(const std::filesystem::path& path) {
  if (!is_scene_file(path)) return import(path);
  in_background(FileWork::Kind::reading, "Opening " + path.filename().string() + "\u2026",
                [this, path]() -> FileWork::Finish {
                  const auto scene = std::make_shared<Scene>(read_scene(path).scene);
                  return [this, path, scene] {
                    after_saving("Open " + path.filename().string(), [this, path, scene] {
                      start(*scene, path);
                      interface.recent.add(path);
                    });
                  };
                });
}

Session::SortedParts Session::sorted_parts(const std::filesystem::path& path) {
  SortedParts sorted;
  MeshParts read = read_parts(path);
  sorted.note = std::move(read.note);
  for (MeshPart& part : read.parts) {
    try {
      if (!Solid::from_mesh(*part.mesh).is_empty()) sorted.sound.push_back(std::move(part));
    } catch (const InvalidSolid& error) {
      sorted.sound_before.push_back(sorted.sound.size());
      sorted.broken.push_back({path, std::move(part), std::make_shared<const InvalidSolid>(error)});
    }
  }
  if (sorted.sound.empty() && sorted.broken.empty())
    throw std::runtime_error(path.filename().string() + " holds no solid: it has no faces.");
  return sorted;
}

void Session::import(const std::filesystem::path& path) {
  in_background(FileWork::Kind::reading, "Reading " + path.filename().string() + "\u2026",
                [this, path]() -> FileWork::Finish {
                  return [this, path, parts = sorted_parts(path)] { take_parts(path, parts); };
                });
}

void Session::take_parts(const std::filesystem::path& path, const SortedParts& parts) {
  const NodeId last = scene().roots().empty() ? 0 : scene().roots().back();
  Selection added;
  if (!parts.sound.empty()) added = add_imported(path, parts.sound);
  if (!parts.note.empty()) interface.messages.tell(parts.note);
  if (parts.broken.empty()) return;
  if (!results.repair.is_open()) {
    end_tool();
    document.drop_draft();
    set_mode(Mode::model);
    camera_before_repair_ = view.camera;
  }
  for (std::size_t i = 0; i < parts.broken.size(); ++i) {
    BrokenMesh mesh = parts.broken[i];
    const std::size_t before = std::min(parts.sound_before[i], added.size());
    mesh.behind = before == 0 ? last : added[before - 1];
    results.repair.put(std::move(mesh));
  }
}

Selection Session::add_imported(const std::filesystem::path& path,
                                const std::vector<MeshPart>& parts, std::size_t at) {
  const bool first = scene().size() == 0;
  Selection added;
  const bool done = change("Import", [&](Scene& changed) {
    std::size_t place = std::min(at, changed.roots().size());
    for (const MeshPart& part : parts) {
      Node node;
      node.name = part.name;
      node.colour = part.colour;
      node.placement.scale = {part.scale, part.scale, part.scale};
      node.what = Imported{path, part.mesh};
      added.push_back(changed.add(std::move(node), 0, place++));
    }
  });
  if (!done) return {};
  interface.recent.add(path);
  select(added);
  if (first) frame_next_ = true;
  return added;
}

void Session::take_repaired() {
  const std::shared_ptr<const RepairPreview> preview = results.repair.shared_preview();
  if (!preview || !preview->mesh) return;
  MeshPart part = results.repair.subject().part;
  const std::filesystem::path path = results.repair.subject().path;
  part.mesh = preview->mesh;
  const NodeId behind = results.repair.subject().behind;
  results.repair.close();
  const std::string name = part.name;
  const auto& roots = scene().roots();
  const auto place = std::find(roots.begin(), roots.end(), behind);
  // Behind all, if the one before it is gone.
  const auto before = std::distance(roots.begin(), place) + (place == roots.end() ? 0 : 1);
  const std::size_t at = behind == 0 ? 0 : static_cast<std::size_t>(before);
  const Selection added = add_imported(path, {std::move(part)}, at);
  if (!added.empty()) results.repair.come_behind(behind, added.front());
  std::string done;
  for (const RepairChange& change : preview->report.changes)
    done += (done.empty() ? ": " : "; ") + in_words(change);
  interface.messages.tell(name + " was repaired" + done + ".");
}

void Session::give_up_repair() {
  results.repair.close();
  if (!results.repair.is_open()) view.camera = camera_before_repair_;
}

void Session::look_at_repair() {
  if (!std::exchange(results.repair.looks, false) || !results.repair.defects()) return;
  const MeshDefects& defects = *results.repair.defects();
  Bounds bounds = defects.bounds;
  if (results.repair.lit >= 0) {
    const MeshDefect& defect = defects.list.at(static_cast<std::size_t>(results.repair.lit));
    if (defect.bounds.is_empty()) return;
    // Of large faces that cross, the place where they do; of a place alone, some of what is around.
    const bool in_part = defect.kind == MeshDefect::Kind::contact && defect.place;
    const glm::dvec3 centre = in_part ? *defect.place : defect.bounds.centre();
    double around = std::max(0.7 * defect.bounds.radius(), 0.06 * bounds.radius());
    if (in_part) around = std::min(around, 0.3 * bounds.radius());
    bounds = {centre - glm::dvec3(around), centre + glm::dvec3(around)};
  }
  view.look_at(bounds);
}

void Session::open_sample(const std::string& name) {
  start(sample_scene(name), {});
  view.presented = scene().roots().front();
  const auto& titles = sample_titles();
  const auto found = std::find_if(titles.begin(), titles.end(),
                                  [&](const SampleTitle& t) { return t.name == name; });
  if (found == titles.end()) return;
  const bool several = found->figure.find(", ") != std::string::npos;
  interface.messages.tell((several ? "Figures " : "Figure ") + found->figure +
                          " of the paper: " + found->title);
}

bool Session::save(const std::filesystem::path& path) {
  try {
    document.save(path);
  } catch (const std::exception& error) {
    interface.messages.error(error.what());
    return false;
  }
  interface.recent.add(path);
  interface.messages.tell("Saved as " + path.filename().string() + ".");
  return true;
}

void Session::export_solid(const std::filesystem::path& path) {
  NodeId id = selected();
  if (selection().size() > 1 || (id == 0 && scene().roots().size() != 1)) {
    interface.messages.error("Select the one solid to export: the scene has several.");
    return;
  }
  if (id == 0) id = scene().roots().front();
  const std::vector<Solid> exported = results.members_of(scene(), id);
  if (exported.empty()) {
    interface.messages.error(
        "There is nothing to export: this solid is empty or could not be computed.");
    return;
  }
  in_background(FileWork::Kind::writing, "Writing " + path.filename().string() + "\u2026",
                [this, path, exported]() -> FileWork::Finish {
                  Solid whole = exported.front();
                  for (std::size_t i = 1; i < exported.size(); ++i)
                    whole = boolean(whole, exported[i], Operation::unite);
                  Rounding rounding;
                  rounding.numbers = numbers_of(format_of(path));
                  write_mesh(path, rounded_mesh(whole, rounding).mesh);
                  return [this, path] {
                    interface.messages.tell("Exported to " + path.filename().string() + ".");
                  };
                });
}

namespace {

/// All of them into one 3MF file, or each into a file beside `path`, named after both. They appear
/// together or not at all. Gives how many files there are.
std::size_t write_solids(const std::filesystem::path& path, const Model& model) {
  if (format_of(path) == FileFormat::three_mf) {
    write_model(path, model);
    return 1;
  }
  WholeFiles files;
  std::set<std::string> taken;
  for (const NamedMesh& solid : model.meshes) {
    std::string name = solid.name;
    for (char& c : name)
      if (c == '/' || c == '\\' || static_cast<unsigned char>(c) < 32) c = '_';
    std::string free = name;
    for (int i = 2; !taken.insert(free).second; ++i) free = name + " " + std::to_string(i);
    const std::filesystem::path file =
        path.parent_path() / (path.stem().string() + "-" + free + path.extension().string());
    std::ostringstream content;
    write_mesh(content, format_of(file), solid.mesh, file.string());
    files.add(file, content.view());
  }
  files.place();
  return model.meshes.size();
}

}  // namespace

namespace {

struct ExportedSolid {
  std::string name;
  std::optional<NodeColour> colour;
  std::vector<Solid> members;  ///< one, or those of a group
};

NamedMesh mesh_of(const ExportedSolid& exported, Rounding::Numbers numbers) {
  Solid whole = exported.members.front();
  for (std::size_t i = 1; i < exported.members.size(); ++i)
    whole = boolean(whole, exported.members[i], Operation::unite);
  Rounding rounding;
  rounding.numbers = numbers;
  return {exported.name, rounded_mesh(whole, rounding).mesh, in_bytes(exported.colour)};
}

}  // namespace

void Session::export_all(const std::filesystem::path& path) {
  std::vector<ExportedSolid> solids;
  for (const NodeId root : scene().roots()) {
    if (!scene().is_shown(root)) continue;
    const Node& node = scene().at(root);
    ExportedSolid exported{node.name, node.colour, results.members_of(scene(), root)};
    if (exported.members.empty())
      return interface.messages.error(
          "\"" + node.name + "\" is empty or could not be computed: hide it to export the others.");
    solids.push_back(std::move(exported));
  }
  if (solids.empty()) {
    interface.messages.error("There is nothing to export: no solid is shown.");
    return;
  }
  in_background(FileWork::Kind::writing, "Writing " + counted(solids.size(), "solid") + "\u2026",
                [this, path, solids]() -> FileWork::Finish {
                  Model model;
                  for (const ExportedSolid& exported : solids)
                    model.meshes.push_back(mesh_of(exported, numbers_of(format_of(path))));
                  const std::size_t files = write_solids(path, model);
                  return [this, path, files, count = solids.size()] {
                    interface.messages.tell(counted(count, "solid") + " exported to " +
                                            (files == 1 ? path.filename().string()
                                                        : counted(files, "file") + " in " +
                                                              path.parent_path().string()) +
                                            ".");
                  };
                });
}

void Session::choose_recording_file() {
  const bool film = interface.recording_plan.is_film();
  interface.dialogs.browse(film ? FileBrowser::Purpose::film : FileBrowser::Purpose::picture,
                           film ? "film.gif" : "picture.png",
                           [this](const std::filesystem::path& path) {
                             interface.recording_plan.path = path;
                             record(interface.recording_plan);
                           });
}

void Session::record(const RecordingPlan& plan) {
  if (const std::string problem = problem_of(plan, results); !problem.empty())
    return interface.messages.error(problem);
  interface.recording.emplace(plan, results, view);
}

void Session::write_recorded() {
  const auto images = std::make_shared<const std::vector<Image>>(interface.recording->take());
  const RecordingPlan plan = interface.recording->plan();
  interface.recording.reset();
  in_background(FileWork::Kind::writing, "Writing " + plan.path.filename().string() + "\u2026",
                [this, plan, images]() -> FileWork::Finish {
                  write_recording(plan, *images);
                  return [this, plan] {
                    interface.messages.tell("Saved as " + plan.path.filename().string() + ".");
                  };
                });
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
    interface.dialogs.ask(std::move(question));
    return;  // one at a time: the others are offered at the next start
  }
}

void Session::recover(const LostWork& work) {
  try {
    Scene scene = Recovery::read(work).scene;
    start({}, {});
    document.commit("Recover", std::move(scene));
    frame_next_ = true;
    // Until there is a copy of this session's, theirs is the only one.
    if (document.keep_copy_now()) Recovery::discard(work);
  } catch (const std::exception& error) {
    interface.messages.error(std::string("The unsaved work cannot be read: ") + error.what());
  }
}

}  // namespace sectile::viewer
