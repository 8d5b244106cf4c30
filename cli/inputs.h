// Files in and out; "-" is standard input or output.
#pragma once

#include "options.h"

namespace sectile::cli {

/// The input is not a legal solid: names the file.
class BadInput : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

PolygonMesh load_mesh(const Options& options, const std::string& name);
Solid load_solid(const Options& options, const std::string& name);

/// Writes all outputs, or none of them.
void save_all(const Options& options, const std::vector<PolygonMesh>& meshes);
/// Text to a file or standard output.
void save_text(const std::string& name, const std::string& text);

}  // namespace sectile::cli
