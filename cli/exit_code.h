// What the program's exit status says; part of its interface (README.md).
#pragma once

namespace sectile::cli {

enum class ExitCode {
  done = 0,
  not_legal = 1,        ///< an input is not a legal solid
  wrong_usage = 2,      ///< the command line does not make sense
  file_failure = 3,     ///< a file cannot be read or written
  internal_failure = 4  ///< a defect of the program, or out of memory
};

}  // namespace sectile::cli
