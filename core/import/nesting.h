// How the shells of a solid lie within each other.
#pragma once

#include <vector>

#include "geometry/kernel.h"
#include "import/shells.h"

namespace sectile {

/// How many layers of material lie on the outer side of a shell: 0 if the shells are nested as
/// those of a solid are.
struct ShellSurroundings {
  FaceId face;  ///< one of the shell's faces, at which this was found
  int material = 0;
};

/// For each shell. Throws InvalidSolid if faces are found that lie on each other.
std::vector<ShellSurroundings> shell_surroundings(const SolidData& data, const Kernel& kernel,
                                                  const Shells& shells);

}  // namespace sectile
