#include "scene/recovery.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>

#include "events/background.h"

namespace sectile::viewer {

namespace {

namespace fs = std::filesystem;

constexpr const char* lock_name = "lock";
constexpr const char* scene_name = "scene.json";
constexpr const char* title_name = "title.txt";

/// Holds a file as long as the process lives. The file holds the process's number for people.
class Lock {
 public:
  explicit Lock(const fs::path& path)
      : file_(open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)) {}
  ~Lock() {
    if (file_ >= 0) close(file_);
  }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;
  bool take() const { return file_ >= 0 && flock(file_, LOCK_EX | LOCK_NB) == 0; }
  bool write_number() const {
    const std::string number = std::to_string(getpid()) + "\n";
    return write(file_, number.data(), number.size()) == static_cast<ssize_t>(number.size());
  }

 private:
  int file_;
};

std::string content_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  if (in) text << in.rdbuf();
  if (!in) throw FileError(path.string() + ": the file cannot be read");
  return std::move(text).str();
}

fs::path recovery_folder(const fs::path& data) {
  return data / "recovery";
}

fs::path new_folder(const fs::path& data) {
  std::error_code error;
  fs::create_directories(recovery_folder(data), error);
  for (int number = 1; !error && number < 10'000; ++number) {
    fs::path folder = recovery_folder(data) /
                      ("session-" + std::to_string(getpid()) + "-" + std::to_string(number));
    if (fs::create_directory(folder, error)) return folder;
  }
  throw FileError(recovery_folder(data).string() + ": no folder for recovery can be made here" +
                  (error ? " (" + error.message() + ")" : ""));
}

}  // namespace

fs::path data_folder() {
  if (const char* set = std::getenv("XDG_DATA_HOME"); set && *set == '/')
    return fs::path(set) / "sectile";
  if (const char* home = std::getenv("HOME"); home && *home)
    return fs::path(home) / ".local/share/sectile";
  return fs::temp_directory_path() / "sectile";
}

class Recovery::Session {
 public:
  explicit Session(const fs::path& data) : folder_(new_folder(data)), lock_(folder_ / lock_name) {
    if (!lock_.take() || !lock_.write_number())
      throw FileError((folder_ / lock_name).string() + ": the file cannot be locked");
    worker_.emplace([this](const Work& work, WorkState&) { return std::optional(attempt(work)); });
  }

  ~Session() {
    worker_.reset();
    std::error_code ignored;  // what stays is found, and offered, at the next start
    fs::remove_all(folder_, ignored);
  }

  void set(std::optional<SceneDocument> document, std::string title) {
    worker_->request({std::move(document), std::move(title)});
  }

  void flush() { worker_->wait(); }

  std::string error() {
    if (auto written = worker_->take()) error_ = std::move(*written);
    return error_;
  }

 private:
  struct Work {
    std::optional<SceneDocument> document;  ///< none: what is there goes
    std::string title;
  };

  /// Why it could not be written; empty if all is well.
  std::string attempt(const Work& work) {
    try {
      if (work.document)
        write(*work.document, work.title);
      else
        fs::remove(folder_ / scene_name);
      return {};
    } catch (const std::exception& error) {
      return error.what();
    }
  }

  void write(const SceneDocument& document, const std::string& title) {
    std::map<MeshPointer, std::string> used;
    const auto name_of = [&](const MeshPointer& mesh) {
      auto known = meshes_.find(mesh);
      if (known == meshes_.end()) {
        std::string name = "mesh-" + std::to_string(++last_mesh_) + ".json";
        write_whole(folder_ / name, mesh_text(*mesh, name));
        known = meshes_.emplace(mesh, std::move(name)).first;
      }
      used.insert(*known);
      return known->second;
    };
    if (title != title_) write_whole(folder_ / title_name, title);
    title_ = title;
    write_whole(folder_ / scene_name, scene_text(document, name_of));
    for (const auto& [mesh, name] : meshes_)
      if (!used.contains(mesh)) fs::remove(folder_ / name);
    meshes_ = std::move(used);
  }

  const fs::path folder_;
  const Lock lock_;
  std::string error_;
  std::map<MeshPointer, std::string> meshes_;  // the files written; the thread's
  std::string title_;
  std::size_t last_mesh_ = 0;
  std::optional<Background<Work, std::string>> worker_;
};

Recovery::Recovery(const fs::path& data) : session_(std::make_unique<Session>(data)) {}
Recovery::~Recovery() = default;

void Recovery::keep(SceneDocument document, std::string title) {
  session_->set(std::move(document), std::move(title));
}
void Recovery::flush() {
  session_->flush();
}
void Recovery::forget() {
  session_->set({}, {});
}
std::string Recovery::error() const {
  return session_->error();
}

std::vector<LostWork> Recovery::find(const fs::path& data) {
  std::vector<LostWork> found;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(recovery_folder(data), none)) {
    const fs::path& folder = entry.path();
    if (!fs::exists(folder / lock_name, none)) continue;
    if (!Lock(folder / lock_name).take()) continue;  // still running
    if (!fs::exists(folder / scene_name, none)) {
      fs::remove_all(folder, none);  // crashed with nothing unsaved
      continue;
    }
    LostWork work{folder, fs::last_write_time(folder / scene_name, none), {}};
    if (fs::exists(folder / title_name, none)) work.title = content_of(folder / title_name);
    found.push_back(std::move(work));
  }
  std::sort(found.begin(), found.end(),
            [](const LostWork& a, const LostWork& b) { return a.saved > b.saved; });
  return found;
}

SceneDocument Recovery::read(const LostWork& work) {
  const auto mesh_of = [&](const std::string& name) {
    const fs::path path = work.folder / fs::path(name).filename();
    return parse_mesh(content_of(path), path.string());
  };
  const fs::path path = work.folder / scene_name;
  return parse_scene(content_of(path), path.string(), mesh_of);
}

void Recovery::discard(const LostWork& work) {
  std::error_code error;
  fs::remove_all(work.folder, error);
  if (error)
    throw FileError(work.folder.string() + ": cannot be removed (" + error.message() + ")");
}

}  // namespace sectile::viewer
