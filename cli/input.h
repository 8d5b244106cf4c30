// Reading operands. "-" is standard input; "parts.3mf#bolt" is one solid of several in a file, by
// its name or its number, counted from 1.
#pragma once

#include <string>
#include <vector>

#include "options.h"
#include "progress.h"
#include "sectile/files.h"
#include "sectile/solid.h"

namespace sectile::cli {

/// Throws UsageError if the names make no sense together. Reads nothing.
void check_inputs(const std::vector<std::string>& names);

FileFormat input_format(const std::string& name, const Options& options);

/// All meshes of the input, or the one that is asked for. Throws FileError.
Model read_input(const std::string& name, const Options& options);

/// What stands behind # for one of `count` solids in a file: its name if it has one, its number if
/// it needs one. `index` is counted from 0.
std::string part_name(const std::string& name, std::size_t index, std::size_t count);

/// Throws IllegalInput.
Solid import_input(const std::string& name, const PolygonMesh& mesh, Progress& progress);

/// Operands, the names of their files, and the unit of those that have one.
struct Operands {
  std::vector<std::string> names;
  std::vector<Solid> solids;
  LengthUnit unit = LengthUnit::millimeter;
};

/// Both for each name. What is several meshes in one file and not asked for one by one is an
/// operand together. Throws UsageError if the operands are in different units.
Operands read_operands(const std::vector<std::string>& names, const Options& options,
                       Progress& progress);

}  // namespace sectile::cli
