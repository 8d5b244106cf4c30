// What goes wrong is told to people on standard error, to programs on standard output, and to both
// by the exit code.
#pragma once

#include <functional>
#include <string>

#include "exit_code.h"
#include "options.h"

namespace sectile::cli {

/// Runs a command and returns its exit code, or that of the exception it throws. Ends the program
/// if it was interrupted.
ExitCode run_and_tell(const std::string& command, const std::function<ExitCode()>& run,
                      const Options& options);

}  // namespace sectile::cli
