// A copy of the unsaved scene, kept in a data folder, that outlives a crash.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "scene/scene_file.h"

namespace sectile::viewer {

/// Where programs keep such data: $XDG_DATA_HOME/sectile or ~/.local/share/sectile.
std::filesystem::path data_folder();

/// What a session that crashed left behind.
struct LostWork {
  std::filesystem::path folder;
  std::filesystem::file_time_type saved;
  std::string title;  ///< as given to Recovery::keep
};

/// One running session. Each has a folder of its own in `data_folder`/recovery with a lock that
/// ends with the process, so that other running sessions are not mistaken for crashed ones.
class Recovery {
 public:
  /// Throws FileError if the folder cannot be made.
  explicit Recovery(const std::filesystem::path& data_folder);
  ~Recovery();  ///< a clean end: the copy goes
  Recovery(const Recovery&) = delete;
  Recovery& operator=(const Recovery&) = delete;

  /// Keeps this document from now on. Returns at once; a thread writes it, the newest only, each
  /// mesh once, and each copy whole or not at all.
  void keep(SceneDocument document, std::string title);
  /// Waits until all that keep() was given is on disk: call it before risky work.
  void flush();
  /// Nothing is unsaved any more.
  void forget();
  /// Why the last copy could not be written; empty if all is well.
  std::string error() const;

  /// Newest first. Empty if none crashed.
  static std::vector<LostWork> find(const std::filesystem::path& data_folder);
  static SceneDocument read(const LostWork& work);  ///< throws FileError
  static void discard(const LostWork& work);

 private:
  class Session;
  std::unique_ptr<Session> session_;
};

}  // namespace sectile::viewer
