// A file that is written beside its place and put there in one step, or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace sectile {

class WholeFile {
 public:
  /// Throws FileError, as all that follows.
  explicit WholeFile(const std::filesystem::path& path);
  /// Leaves nothing behind but what place() put there.
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  void write(std::string_view content);
  /// All is written; throws if the system objects only now.
  void finish();
  /// Puts the file into its place; `keep_old` so that undo() can bring back what was there.
  void place(bool keep_old = false);
  void undo() noexcept;

 private:
  void open_beside();
  void open_device();
  void keep_old_content();
  [[noreturn]] void fail(int error) const;

  std::string named_;             // what the user calls it
  std::filesystem::path target_;  // behind links
  std::filesystem::path staged_;  // empty for devices and pipes, which are not replaced
  std::filesystem::path old_;     // what was in the place, if it is kept
  bool placed_ = false;
  int file_ = -1;
};

}  // namespace sectile
