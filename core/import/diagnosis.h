// Words for what is wrong with an input.
#pragma once

#include <string>

#include "sectile/mesh.h"

namespace sectile {

/// "(x, y, z)", with as many digits as it takes to tell the doubles from others.
std::string in_words(const Vec3& p);
/// As many digits as it takes.
std::string in_words(double value);

}  // namespace sectile
