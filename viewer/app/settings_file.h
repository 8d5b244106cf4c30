// The settings that outlive a session, as lines "name value".
#pragma once

#include <filesystem>

#include "app/view_settings.h"

namespace sectile::viewer {

/// Without a file, or where a line says nothing known, the settings stay.
/// `folder` is where the file browser was last.
void load_settings(const std::filesystem::path& path, ViewSettings& settings,
                   std::filesystem::path& folder);
/// Throws FileError.
void save_settings(const std::filesystem::path& path, const ViewSettings& settings,
                   const std::filesystem::path& folder);

}  // namespace sectile::viewer
