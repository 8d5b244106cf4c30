// The tour of the paper as a page.
#pragma once

#include <filesystem>

namespace sectile::viewer {

/// Writes index.html into the folder, which is made if it is not there; gives its path.
std::filesystem::path write_tour(const std::filesystem::path& folder);

}  // namespace sectile::viewer
