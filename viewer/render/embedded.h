// Files that are part of the program: shaders and fonts.
#pragma once

#include <string_view>

namespace sectile::viewer {

/// The contents of a file by its name without folder; throws std::out_of_range.
std::string_view embedded_file(std::string_view name);

}  // namespace sectile::viewer
