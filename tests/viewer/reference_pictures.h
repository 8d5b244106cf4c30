// Pictures that were looked at and kept, to compare with.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "render/graphics_context.h"

namespace sectile::viewer {

/// The greatest LocalDifference that is no fault.
constexpr double tolerated_difference = 0.03;

/// Where the kept pictures are, and where new ones that differ are written.
std::filesystem::path reference_folder();
std::filesystem::path new_pictures_folder();

/// Compares with the kept picture `name`.png. If it differs, or there is none, writes the new one
/// and a picture of the difference, and says where; otherwise returns nothing.
std::string difference_from_reference(const std::string& name, const Image& image);

/// The names of all kept pictures.
std::vector<std::string> reference_names();

}  // namespace sectile::viewer
