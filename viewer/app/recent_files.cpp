#include "app/recent_files.h"

#include <fstream>
#include <string>

#include "sectile/files.h"

namespace sectile::viewer {
namespace {

constexpr std::size_t most = 10;

}  // namespace

RecentFiles::RecentFiles(std::filesystem::path kept_in) : kept_in_(std::move(kept_in)) {
  std::ifstream in(kept_in_);
  for (std::string line; list_.size() < most && std::getline(in, line);)
    if (!line.empty()) list_.emplace_back(line);
}

void RecentFiles::add(const std::filesystem::path& file) {
  std::error_code error;
  std::filesystem::path whole = std::filesystem::absolute(file, error);
  // A line cannot hold such a name.
  if (error || whole.string().find('\n') != std::string::npos) return;
  whole = whole.lexically_normal();
  std::erase(list_, whole);
  list_.insert(list_.begin(), whole);
  if (list_.size() > most) list_.resize(most);
  keep();
}

void RecentFiles::clear() {
  list_.clear();
  keep();
}

void RecentFiles::keep() const {
  if (kept_in_.empty()) return;
  std::string text;
  for (const std::filesystem::path& file : list_) text += file.string() + '\n';
  std::filesystem::create_directories(kept_in_.parent_path());
  write_whole(kept_in_, text);
}

}  // namespace sectile::viewer
