// The files opened and saved last, the newest first; kept in the data folder, one path a line.
#pragma once

#include <filesystem>
#include <vector>

namespace sectile::viewer {

class RecentFiles {
 public:
  RecentFiles() = default;
  /// Reads what is there, and writes again with each change. An empty path keeps nothing.
  explicit RecentFiles(std::filesystem::path kept_in);

  const std::vector<std::filesystem::path>& list() const { return list_; }
  void add(const std::filesystem::path& file);
  void clear();

 private:
  void keep() const;
  std::filesystem::path kept_in_;
  std::vector<std::filesystem::path> list_;
};

}  // namespace sectile::viewer
