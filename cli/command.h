// The commands of the program.
#pragma once

#include <functional>

#include "exit_code.h"
#include "options.h"
#include "sectile/boolean.h"

namespace sectile::cli {

/// A command as it is parsed, and what to do if it was given.
struct Command {
  CLI::App* app;
  std::function<ExitCode()> run;
};

// Each adds its command to the program. `options` must outlive it.
Command add_boolean_command(CLI::App& program, Operation operation, Options& options);
Command add_split_command(CLI::App& program, Options& options);
Command add_check_command(CLI::App& program, Options& options);
Command add_info_command(CLI::App& program, Options& options);
Command add_convert_command(CLI::App& program, Options& options);
Command add_repair_command(CLI::App& program, Options& options);
Command add_trace_command(CLI::App& program, Options& options);

}  // namespace sectile::cli
