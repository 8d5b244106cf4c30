// The names of file formats and units on the command line.
#pragma once

#include <string>
#include <vector>

#include "sectile/files.h"

namespace sectile::cli {

const std::vector<std::string>& format_names();
/// The name must be one of format_names().
FileFormat format_named(const std::string& name);
const std::string& name_of(FileFormat format);
/// As 3MF calls them.
const std::string& name_of(LengthUnit unit);

}  // namespace sectile::cli
