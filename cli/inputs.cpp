#include "inputs.h"

#include <filesystem>
#include <iostream>
#include <sstream>

namespace sectile::cli {
namespace {

FileFormat stream_format(const Options& options) {
  return format_of("stream." + options.format);
}

std::string content_of(const PolygonMesh& mesh, FileFormat format, const std::string& name) {
  std::ostringstream out;
  write_mesh(out, format, mesh, name);
  return out.str();
}

}  // namespace

PolygonMesh load_mesh(const Options& options, const std::string& name) {
  if (name == "-") return read_mesh(std::cin, stream_format(options), "standard input");
  return read_mesh(std::filesystem::path(name));
}

Solid load_solid(const Options& options, const std::string& name) {
  const PolygonMesh mesh = load_mesh(options, name);
  try {
    return Solid::from_mesh(mesh);
  } catch (const InvalidSolid& error) {
    throw BadInput(name + ": not a legal solid: " + error.what());
  }
}

void save_text(const std::string& name, const std::string& text) {
  if (name != "-") return write_whole(name, text);
  std::cout << text << std::flush;
  if (!std::cout) throw FileError("standard output: cannot write");
}

void save_all(const Options& options, const std::vector<PolygonMesh>& meshes) {
  // Everything is formatted, and unknown extensions are found, before anything is written.
  std::vector<std::string> contents;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const std::string& name = options.outputs[i];
    contents.push_back(
        content_of(meshes[i], name == "-" ? stream_format(options) : format_of(name), name));
  }
  std::vector<std::string> written;
  try {
    for (std::size_t i = 0; i < contents.size(); ++i) {
      const bool is_new = options.outputs[i] != "-" && !std::filesystem::exists(options.outputs[i]);
      save_text(options.outputs[i], contents[i]);
      if (is_new) written.push_back(options.outputs[i]);
    }
  } catch (...) {
    std::error_code ignored;  // the first error is the one to tell
    for (const std::string& name : written) std::filesystem::remove(name, ignored);
    throw;
  }
}

}  // namespace sectile::cli
