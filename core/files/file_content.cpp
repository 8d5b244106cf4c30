#include "files/file_content.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <istream>

#include "sectile/errors.h"

namespace sectile {
namespace {

constexpr std::size_t piece_size = std::size_t{1} << 20;

[[noreturn]] void fail(std::string_view name, const char* doing, int error) {
  throw FileError(std::string(name) + ": cannot " + doing + ": " + std::strerror(error));
}

// Files of empty solids have a header; a file without a byte was cut off.
std::string require_content(std::string&& content, std::string_view name) {
  if (content.empty()) throw FileError(std::string(name) + ":1: the file is empty");
  return std::move(content);
}

class OpenFile {
 public:
  explicit OpenFile(const std::filesystem::path& path) : name_(path.string()) {
    do file_ = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    while (file_ < 0 && errno == EINTR);
    if (file_ < 0) fail(name_, "open", errno);
  }
  ~OpenFile() { close(file_); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  /// What can be expected; pipes do not tell.
  std::size_t size() const {
    struct stat status {};
    if (fstat(file_, &status) != 0) fail(name_, "read", errno);
    return S_ISREG(status.st_mode) ? static_cast<std::size_t>(status.st_size) : 0;
  }
  std::size_t read(char* to, std::size_t most) {
    ssize_t count = 0;
    do count = ::read(file_, to, most);
    while (count < 0 && errno == EINTR);
    if (count < 0) fail(name_, "read", errno);
    return static_cast<std::size_t>(count);
  }

 private:
  std::string name_;
  int file_ = -1;
};

}  // namespace

std::string content_of(const std::filesystem::path& path) {
  OpenFile file(path);
  // One byte more than the file has shows its end without another piece.
  std::string content(file.size() + 1, '\0');
  std::size_t size = 0;
  while (const std::size_t count = file.read(content.data() + size, content.size() - size)) {
    size += count;
    if (size == content.size()) content.resize(2 * size + piece_size);
  }
  content.resize(size);
  return require_content(std::move(content), path.string());
}

std::string content_of(std::istream& in, std::string_view name) {
  std::string content;
  std::size_t size = 0;
  do {
    content.resize(2 * size + piece_size);
    in.read(content.data() + size, static_cast<std::streamsize>(content.size() - size));
    size += static_cast<std::size_t>(in.gcount());
  } while (in);
  if (in.bad()) fail(name, "read", EIO);
  content.resize(size);
  return require_content(std::move(content), name);
}

}  // namespace sectile
