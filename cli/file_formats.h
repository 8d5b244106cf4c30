// The names of file formats on the command line.
#pragma once

#include <string>
#include <vector>

#include "sectile/files.h"

namespace sectile::cli {

const std::vector<std::string>& format_names();
/// The name must be one of format_names().
FileFormat format_named(const std::string& name);
const std::string& name_of(FileFormat format);

}  // namespace sectile::cli
