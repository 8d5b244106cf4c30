#include "sectile/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <sstream>

#include "files/formats.h"
#include "sectile/errors.h"

namespace sectile {

std::string shortest(double value) {
  char buffer[40];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

FileFormat format_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".obj") return FileFormat::obj;
  if (extension == ".stl") return FileFormat::stl_binary;
  if (extension == ".off") return FileFormat::off;
  if (extension == ".ply") return FileFormat::ply_text;
  throw FileError(path.string() + ": unknown extension \"" + extension +
                  "\"; known are .obj, .stl, .off and .ply");
}

namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const char* doing) {
  throw FileError(path.string() + ": cannot " + doing + ": " + std::strerror(errno));
}

PolygonMesh parse(std::string_view content, FileFormat format, std::string_view name) {
  switch (format) {
    case FileFormat::obj:
      return read_obj(content, name);
    case FileFormat::stl_text:
    case FileFormat::stl_binary:
      return read_stl(content, name);
    case FileFormat::off:
      return read_off(content, name);
    case FileFormat::ply_text:
    case FileFormat::ply_binary:
      break;
  }
  return read_ply(content, name);
}

std::string content_of(const std::filesystem::path& path) {
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in) fail(path, "open");
  std::string content{std::istreambuf_iterator<char>(in), {}};
  if (in.bad() || errno == EISDIR) fail(path, "read");
  return content;
}

// A file of its own beside the wanted one; gone unless it was put into place.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& path) : path_(path) {
    name_ = path.string() + ".XXXXXX";
    file_ = mkstemp(name_.data());
    if (file_ < 0) fail(path_, "write");
    // As any new file, not only for its owner.
    const mode_t mask = umask(0);
    umask(mask);
    if (fchmod(file_, 0666 & ~mask) != 0) fail(path_, "write");
  }
  ~TemporaryFile() {
    if (file_ >= 0) close(file_);
    if (!placed_) unlink(name_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  void write(std::string_view content) {
    while (!content.empty()) {
      const ssize_t n = ::write(file_, content.data(), content.size());
      if (n < 0) fail(path_, "write");
      content.remove_prefix(static_cast<std::size_t>(n));
    }
  }
  void place() {
    if (fsync(file_) != 0) fail(path_, "write");
    const int file = file_;
    file_ = -1;
    if (close(file) != 0 || rename(name_.c_str(), path_.c_str()) != 0) fail(path_, "write");
    placed_ = true;
  }

 private:
  std::filesystem::path path_;
  std::string name_;
  int file_ = -1;
  bool placed_ = false;
};

}  // namespace

PolygonMesh read_mesh(const std::filesystem::path& path) {
  const FileFormat format = format_of(path);
  return parse(content_of(path), format, path.string());
}

PolygonMesh read_mesh(std::istream& in, FileFormat format, std::string_view name) {
  const std::string content{std::istreambuf_iterator<char>(in), {}};
  if (in.bad()) throw FileError(std::string(name) + ": cannot read");
  return parse(content, format, name);
}

void write_mesh(std::ostream& out, FileFormat format, const PolygonMesh& mesh,
                std::string_view name) {
  switch (format) {
    case FileFormat::obj:
      write_obj(out, mesh);
      break;
    case FileFormat::stl_text:
      write_stl_text(out, mesh);
      break;
    case FileFormat::stl_binary:
      write_stl_binary(out, mesh);
      break;
    case FileFormat::off:
      write_off(out, mesh);
      break;
    case FileFormat::ply_text:
      write_ply_text(out, mesh);
      break;
    case FileFormat::ply_binary:
      write_ply_binary(out, mesh);
      break;
  }
  out.flush();
  if (!out) throw FileError(std::string(name) + ": cannot write");
}

void write_mesh(const std::filesystem::path& path, const PolygonMesh& mesh) {
  std::ostringstream out;
  write_mesh(out, format_of(path), mesh, path.string());
  write_whole(path, out.view());
}

void write_whole(const std::filesystem::path& path, std::string_view content) {
  TemporaryFile file(path);
  file.write(content);
  file.place();
}

}  // namespace sectile
