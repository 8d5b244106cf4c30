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
  /// Leaves nothing behind unless place() was done.
  ~WholeFile();
  WholeFile(const WholeFile&) = delete;
  WholeFile& operator=(const WholeFile&) = delete;

  void write(std::string_view content);
  /// Puts the file into its place.
  void place();

 private:
  void open_beside();
  void open_device();
  [[noreturn]] void fail(int error) const;

  std::string named_;             // what the user calls it
  std::filesystem::path target_;  // behind links
  std::filesystem::path staged_;  // empty for devices and pipes, which are not replaced
  int file_ = -1;
};

}  // namespace sectile
