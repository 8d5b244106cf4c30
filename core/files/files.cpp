#include "sectile/files.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <ostream>

#include "files/file_content.h"
#include "files/formats.h"
#include "files/whole_file.h"
#include "files/writable.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

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

void render(Sink& out, FileFormat format, const PolygonMesh& mesh, std::string_view name) {
  require_writable(mesh, name);
  switch (format) {
    case FileFormat::obj:
      write_obj(out, mesh);
      break;
    case FileFormat::stl_text:
      write_stl_text(out, mesh, name);
      break;
    case FileFormat::stl_binary:
      write_stl_binary(out, mesh, name);
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
  out.finish();
}

}  // namespace

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

PolygonMesh read_mesh(const std::filesystem::path& path) {
  const FileFormat format = format_of(path);
  return parse(content_of(path), format, path.string());
}

PolygonMesh read_mesh(std::istream& in, FileFormat format, std::string_view name) {
  return parse(content_of(in, name), format, name);
}

void write_mesh(const std::filesystem::path& path, const PolygonMesh& mesh) {
  const FileFormat format = format_of(path);
  WholeFile file(path);
  Sink sink([&](std::string_view text) { file.write(text); });
  render(sink, format, mesh, path.string());
  file.place();
}

void write_mesh(std::ostream& out, FileFormat format, const PolygonMesh& mesh,
                std::string_view name) {
  const auto require_good = [&] {
    if (out) return;
    const std::string reason = errno != 0 ? std::strerror(errno) : "the stream takes no more";
    throw FileError(std::string(name) + ": cannot write: " + reason);
  };
  errno = 0;
  Sink sink([&](std::string_view text) {
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
    require_good();
  });
  render(sink, format, mesh, name);
  out.flush();
  require_good();
}

}  // namespace sectile
