#include "boolean/save_operands.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <system_error>

#include "sectile/exact_file.h"

namespace sectile {
namespace {

// A new file that nobody can have foreseen, for the user alone.
class NewFile {
 public:
  explicit NewFile(const std::string& prefix)
      : path_((std::filesystem::temp_directory_path() / (prefix + "XXXXXX.exact")).string()),
        file_(mkstemps(path_.data(), 6)) {
    if (file_ < 0) fail();
  }
  ~NewFile() { close(file_); }
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  const std::string& path() const { return path_; }
  void write(std::string_view text) {
    while (!text.empty()) {
      const ssize_t written = ::write(file_, text.data(), text.size());
      if (written < 0 && errno != EINTR) fail();
      if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
    }
  }

 private:
  [[noreturn]] void fail() const { throw std::system_error(errno, std::generic_category(), path_); }

  std::string path_;
  int file_;
};

std::string save(const char* prefix, const Solid& solid) {
  std::ostringstream text;
  write_exact(text, solid);
  NewFile file(prefix);
  file.write(text.view());
  return file.path();
}

}  // namespace

std::string save_operands(const Solid& a, const Solid& b) {
  try {
    const std::string first = save("sectile-a-", a), second = save("sectile-b-", b);
    return "the operands were saved exactly as " + first + " and " + second;
  } catch (const std::exception& error) {
    return std::string("the operands could not be saved: ") + error.what();
  }
}

}  // namespace sectile
