// What the program's exit says.
#pragma once

namespace sectile::cli {

enum ExitCode : int {
  done = 0,
  not_a_solid = 1,  ///< the input is not a legal solid
  wrong_usage = 2,
  file_trouble = 3,  ///< a file cannot be read or written
  internal = 4,      ///< a defect of the program; the operands were saved
  cancelled = 5      ///< interrupted; nothing was written
};

}  // namespace sectile::cli
