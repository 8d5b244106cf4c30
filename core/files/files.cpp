#include "sectile/files.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <ostream>

#include "files/append.h"
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
      return read_ply(content, name);
    case FileFormat::three_mf:
      break;
  }
  return joined(read_three_mf(content, name), name);
}

Model parse_model(std::string_view content, FileFormat format, std::string_view name) {
  if (format == FileFormat::three_mf) return read_three_mf(content, name);
  Model model;
  model.meshes.push_back({{}, parse(content, format, name)});
  return model;
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
    case FileFormat::three_mf:
      write_three_mf(out, {LengthUnit::millimeter, {{{}, mesh}}}, name);
      break;
  }
}

void render(Sink& out, FileFormat format, const Model& model, std::string_view name) {
  if (format == FileFormat::three_mf) {
    for (const NamedMesh& part : model.meshes) require_writable(part.mesh, name);
    write_three_mf(out, model, name);
    return;
  }
  if (model.meshes.size() != 1)
    throw FileError(std::string(name) + ": cannot write: only 3MF holds " +
                    std::to_string(model.meshes.size()) + " meshes, the other formats one");
  render(out, format, model.meshes.front().mesh, name);
}

// `shape` is a mesh or a model.
template <class Shape>
void write_file(const std::filesystem::path& path, const Shape& shape) {
  const FileFormat format = format_of(path);
  WholeFile file(path);
  Sink sink([&](std::string_view text) { file.write(text); });
  render(sink, format, shape, path.string());
  sink.finish();
  file.place();
}

template <class Shape>
void write_stream(std::ostream& out, FileFormat format, const Shape& shape, std::string_view name) {
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
  render(sink, format, shape, name);
  sink.finish();
  out.flush();
  require_good();
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
  if (extension == ".3mf") return FileFormat::three_mf;
  throw FileError(path.string() + ": unknown extension \"" + extension +
                  "\"; known are .obj, .stl, .off, .ply and .3mf");
}

PolygonMesh read_mesh(const std::filesystem::path& path) {
  const FileFormat format = format_of(path);
  return parse(content_of(path), format, path.string());
}

PolygonMesh read_mesh(std::istream& in, FileFormat format, std::string_view name) {
  return parse(content_of(in, name), format, name);
}

Model read_model(const std::filesystem::path& path) {
  const FileFormat format = format_of(path);
  return parse_model(content_of(path), format, path.string());
}

Model read_model(std::istream& in, FileFormat format, std::string_view name) {
  return parse_model(content_of(in, name), format, name);
}

PolygonMesh joined(const Model& model, std::string_view name) {
  PolygonMesh all;
  for (const NamedMesh& part : model.meshes) append(all, part.mesh, name);
  return all;
}

void write_mesh(const std::filesystem::path& path, const PolygonMesh& mesh) {
  write_file(path, mesh);
}

void write_mesh(std::ostream& out, FileFormat format, const PolygonMesh& mesh,
                std::string_view name) {
  write_stream(out, format, mesh, name);
}

void write_model(const std::filesystem::path& path, const Model& model) {
  write_file(path, model);
}

void write_model(std::ostream& out, FileFormat format, const Model& model, std::string_view name) {
  write_stream(out, format, model, name);
}

}  // namespace sectile
