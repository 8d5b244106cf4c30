// Reading operands. "-" is standard input.
#pragma once

#include <string>
#include <vector>

#include "options.h"
#include "progress.h"
#include "sectile/solid.h"

namespace sectile::cli {

/// Throws UsageError if the names make no sense together. Reads nothing.
void check_inputs(const std::vector<std::string>& names);

FileFormat input_format(const std::string& name, const Options& options);

/// Throws FileError.
PolygonMesh read_input(const std::string& name, const Options& options);

/// Throws IllegalInput; with `validate` also if faces cross.
Solid import_input(const std::string& name, const PolygonMesh& mesh, bool validate);

/// Both for each name.
std::vector<Solid> read_solids(const std::vector<std::string>& names, const Options& options,
                               Progress& progress);

/// Throws IllegalInput if the validator objects to the solid read from this file.
void require_legal(const std::string& name, const Solid& solid);

}  // namespace sectile::cli
