#include "app/dialogs.h"

#include <algorithm>
#include <cctype>
#include <system_error>

namespace sectile::viewer {
namespace {

std::vector<std::string> extensions_for(FileBrowser::Purpose purpose) {
  switch (purpose) {
    case FileBrowser::Purpose::save:
      return {".sectile"};
    case FileBrowser::Purpose::open:
      return {".sectile", ".obj", ".stl", ".off", ".ply", ".3mf"};
    case FileBrowser::Purpose::import:
    case FileBrowser::Purpose::export_solid:
    case FileBrowser::Purpose::export_all:
      return {".obj", ".stl", ".off", ".ply", ".3mf"};
    case FileBrowser::Purpose::picture:
      return {".png"};
    case FileBrowser::Purpose::film:
      return {".gif", ".png"};
  }
  return {};
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool writes(FileBrowser::Purpose purpose) {
  return purpose != FileBrowser::Purpose::open && purpose != FileBrowser::Purpose::import;
}

}  // namespace

void FileBrowser::show(std::filesystem::path wanted) {
  std::error_code error;
  wanted = std::filesystem::weakly_canonical(wanted, error);
  std::vector<Entry> found;
  for (std::filesystem::directory_iterator it(wanted, error), end; !error && it != end;
       it.increment(error)) {
    const std::string file = it->path().filename().string();
    if (file.empty() || file.front() == '.') continue;
    std::error_code ignored;  // a link that leads nowhere is not shown
    if (it->is_directory(ignored)) {
      found.push_back({file, true, 0});
    } else if (it->is_regular_file(ignored) &&
               std::count(extensions.begin(), extensions.end(), lower(it->path().extension()))) {
      found.push_back({file, false, it->file_size(ignored)});
    }
  }
  if (error) {
    problem = "The folder " + wanted.string() + " cannot be read: " + error.message() + ".";
    return;
  }
  std::sort(found.begin(), found.end(), [](const Entry& a, const Entry& b) {
    return a.is_folder != b.is_folder ? a.is_folder : lower(a.name) < lower(b.name);
  });
  folder = wanted;
  entries = std::move(found);
  problem.clear();
  asks_to_replace = false;
}

bool FileBrowser::accept() {
  problem.clear();
  if (name.empty()) {
    problem = "Type a name or choose a file from the list.";
    return false;
  }
  std::filesystem::path path = folder / name;  // an absolute name replaces the folder
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) {
    show(path);
    name.clear();
    return false;
  }
  if (writes(purpose) && path.extension().empty()) path += extensions.front();
  if (!std::count(extensions.begin(), extensions.end(), lower(path.extension()))) {
    problem = "The name must end in";
    for (const std::string& extension : extensions) problem += " " + extension;
    problem += ".";
    return false;
  }
  const bool exists = std::filesystem::exists(path, error);
  if (!writes(purpose) && !exists) {
    problem = "There is no file " + path.filename().string() + " in this folder.";
    return false;
  }
  if (writes(purpose) && exists && !asks_to_replace) {
    asks_to_replace = true;
    problem = path.filename().string() + " is there already. Press the button again to replace it.";
    return false;
  }
  // The next file is wanted from where this one is.
  folder = path.parent_path();
  if (chosen) chosen(path);
  return true;
}

void Dialogs::ask(Question question) {
  questions.push_back(std::move(question));
}

void Dialogs::browse(FileBrowser::Purpose purpose, const std::string& name,
                     std::function<void(const std::filesystem::path&)> chosen) {
  const std::filesystem::path folder =
      browser.folder.empty() ? std::filesystem::current_path() : browser.folder;
  browser.purpose = purpose;
  browser.name = name;
  browser.extensions = extensions_for(purpose);
  browser.chosen = std::move(chosen);
  browser.show(folder);
  browsing = true;
}

}  // namespace sectile::viewer
