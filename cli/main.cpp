// The command line program. Its interface is described in README.md and by --help.
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <csignal>

#include "command.h"
#include "failures.h"

namespace sectile::cli {
namespace {

constexpr const char* examples = R"(Examples:
  sectile union bracket.obj bolt.stl nut.ply -o assembly.obj
  sectile subtract block.off drill1.off drill2.off -o drilled.stl
  sectile split part.obj --plane 0,0,1,-10 -o above.obj below.obj
  sectile check part.stl --json
  sectile repair soup.stl -o part.obj
  sectile convert parts.3mf#lid -o lid.off
  sectile convert part.ply -o - --output-format stl-text > part.stl
  unzip -p parts.zip part.stl | sectile intersect - box.off --input-format stl -o cut.off
  sectile trace a.obj b.obj --op subtract -o trace.json

Files are OBJ, STL, OFF, PLY or 3MF by their extension; - is standard input or output,
OBJ unless --input-format or --output-format says otherwise. parts.3mf#lid is one of several
solids in a 3MF file, by name or number (sectile info lists them).
Outputs appear whole or not at all.
Exit codes: 0 done, 1 an input is not a legal solid, 2 wrong usage,
  3 a file cannot be read or written, 4 internal error or out of memory.
Help on a command: sectile COMMAND --help)";

void describe(CLI::App& program) {
  program.description("Exact Boolean operations on polyhedral solids");
  program.name("sectile");
  program.set_version_flag("--version", "sectile " SECTILE_VERSION, "print the version");
  program.set_help_flag("-h,--help", "print this help");
  program.require_subcommand(1);
  program.footer(examples);
}

std::vector<Command> add_commands(CLI::App& program, Options& options) {
  return {add_boolean_command(program, Operation::unite, options),
          add_boolean_command(program, Operation::intersect, options),
          add_boolean_command(program, Operation::subtract, options),
          add_split_command(program, options),
          add_check_command(program, options),
          add_info_command(program, options),
          add_convert_command(program, options),
          add_repair_command(program, options),
          add_trace_command(program, options)};
}

ExitCode run(const Command& command, const Options& options) {
  // Never taken back: that would start threads, and terminate the program if the system refuses
  // one.
  [[maybe_unused]] static const tbb::global_control* limit = nullptr;
  if (options.threads)
    limit = new tbb::global_control(tbb::global_control::max_allowed_parallelism, *options.threads);
  return run_and_tell(command.app->get_name(), command.run, options);
}

int run(int count, char** arguments) {
  // A reader that goes away is an error of writing, not the end of the program.
  std::signal(SIGPIPE, SIG_IGN);
  CLI::App program;
  Options options;
  describe(program);
  const std::vector<Command> commands = add_commands(program, options);
  try {
    program.parse(count, arguments);
  } catch (const CLI::ParseError& error) {
    const bool done = program.exit(error) == 0;  // prints help, the version or what is wrong
    return static_cast<int>(done ? ExitCode::done : ExitCode::wrong_usage);
  }
  for (const Command& command : commands)
    if (command.app->parsed()) return static_cast<int>(run(command, options));
  return static_cast<int>(ExitCode::wrong_usage);
}

}  // namespace
}  // namespace sectile::cli

int main(int count, char** arguments) {
  return sectile::cli::run(count, arguments);
}
