// A file that was written beside its place and can be put there in one step, and taken back.
#pragma once

#include <filesystem>
#include <string_view>

namespace sectile::cli {

class StagedFile {
 public:
  /// Writes the content beside `target`. Throws FileError.
  StagedFile(const std::filesystem::path& target, std::string_view content);
  /// Removes whatever is not in its place.
  ~StagedFile();
  StagedFile(const StagedFile&) = delete;
  StagedFile& operator=(const StagedFile&) = delete;

  /// Replaces the target; `keep_old` so that undo() can bring back what was there. Throws
  /// FileError.
  void place(bool keep_old);
  void undo() noexcept;

 private:
  void keep_old_content();

  std::filesystem::path named_, target_, staged_, old_;
  bool placed_ = false, had_old_ = false;
};

}  // namespace sectile::cli
