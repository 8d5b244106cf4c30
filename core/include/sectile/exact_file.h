// Solids with their exact numbers, as text: what a mesh rounds is kept.
#pragma once

#include <iosfwd>
#include <string_view>

#include "sectile/solid.h"

namespace sectile {

/// Writes the boundary as it is stored: points as doubles, moved doubles or three planes, faces
/// with holes and their sources. It is for operations that failed, to be done again elsewhere;
/// versions of the library read what they wrote themselves. Throws std::ios_base::failure if `out`
/// does.
void write_exact(std::ostream& out, const Solid& solid);

/// Throws FileError (the message starts with NAME) for what write_exact() does not write. Whether
/// the solid is legal is for validate() to say.
Solid read_exact(std::istream& in, std::string_view name);

}  // namespace sectile
