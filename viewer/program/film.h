// Films without a window: a turntable, or the steps of an operation.
#pragma once

#include "program/arguments.h"

namespace sectile::viewer {

/// Draws and writes `arguments.film`; gives what was written first. Throws std::invalid_argument,
/// FileError and std::runtime_error.
std::filesystem::path write_film(const Arguments& arguments);

}  // namespace sectile::viewer
