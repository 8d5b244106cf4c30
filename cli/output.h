// Writing results. "-" is standard output. Several outputs appear together or not at all.
#pragma once

#include <string>
#include <vector>

#include "options.h"
#include "sectile/files.h"

namespace sectile::cli {

struct Output {
  std::string name;
  std::string content;
};

/// Throws before any work is done: UsageError if the names make no sense, FileError if a file could
/// not be written anyway.
void check_outputs(const std::vector<std::string>& names, const Options& options);

/// The same and for meshes: each must have a format.
void check_mesh_outputs(const std::vector<std::string>& names, const Options& options);

FileFormat output_format(const std::string& name, const Options& options);

/// Throws FileError if the format cannot hold the model.
Output rendered(const std::string& name, const Model& model, const Options& options);

/// Throws FileError, or Cancelled if a signal came meanwhile; then nothing was changed.
void write_outputs(const std::vector<Output>& outputs);

/// Does one of them go to standard output?
bool uses_standard_output(const std::vector<std::string>& names);

}  // namespace sectile::cli
