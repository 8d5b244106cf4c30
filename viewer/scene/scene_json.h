// The JSON forms of what scene files hold; shared by the writer and the reader.
#pragma once

#include <array>
#include <string_view>

#include "scene/scene.h"

namespace sectile::viewer {

inline constexpr int scene_file_version = 1;
inline constexpr std::string_view scene_file_kind = "sectile scene";

inline constexpr std::array<std::string_view, 3> operation_names{"unite", "intersect", "subtract"};

inline constexpr std::array<std::string_view, 4> pattern_names{"linear", "polar", "path", "mirror"};

}  // namespace sectile::viewer
