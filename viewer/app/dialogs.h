// Questions and the file browser: what is being asked, as data; the panels draw it.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace sectile::viewer {

/// A question with up to three answers; closing it is the last one.
struct Question {
  std::string title, text;
  struct Answer {
    std::string name, text;
    std::function<void()> run;
  };
  std::vector<Answer> answers;
};

/// Choosing a file to read or to write.
struct FileBrowser {
  enum class Purpose { open, save, import, export_solid, export_all, picture, film };
  struct Entry {
    std::string name;
    bool is_folder = false;
    std::uintmax_t size = 0;
  };
  Purpose purpose = Purpose::open;
  std::filesystem::path folder;
  std::string name;                     ///< what stands in the field
  std::vector<std::string> extensions;  ///< ".obj", …; the first is added to a name without
  std::vector<Entry> entries;
  std::string problem;  ///< why the folder cannot be shown, or the name not used
  bool asks_to_replace = false;
  std::function<void(const std::filesystem::path&)> chosen;

  void show(std::filesystem::path wanted);  ///< lists a folder
  /// Takes what stands in the field: enters a folder, or answers with a file. True when done.
  bool accept();
};

class Dialogs {
 public:
  void ask(Question question);
  void browse(FileBrowser::Purpose purpose, const std::string& name,
              std::function<void(const std::filesystem::path&)> chosen);
  bool is_open() const { return !questions.empty() || browsing; }

  std::vector<Question> questions;  ///< the first one is shown
  FileBrowser browser;
  bool browsing = false;
  bool recording = false;            ///< pictures and films
  bool about = false, keys = false;  ///< windows of the Help menu
};

}  // namespace sectile::viewer
