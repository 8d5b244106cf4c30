// Operands of an operation that failed are saved for reproduction.
#pragma once

#include <string>

#include "sectile/solid.h"

namespace sectile {

/// Writes both operands exactly (sectile/exact_file.h) into new files in the folder for temporary
/// files, which only the user can read. Says in words where, or why that was not possible.
std::string save_operands(const Solid& a, const Solid& b);

}  // namespace sectile
