#include "options.h"

#include <CLI/CLI.hpp>

#include "file_formats.h"

namespace sectile::cli {
namespace {

void add_format(CLI::App& command, const std::string& flag, std::optional<FileFormat>& format,
                const std::string& help) {
  command
      .add_option_function<std::string>(
          flag, [&format](const std::string& name) { format = format_named(name); }, help)
      ->check(CLI::IsMember(format_names()))
      ->type_name("FORMAT");
}

}  // namespace

void add_reporting(CLI::App& command, Options& options) {
  command.add_flag("--json", options.json,
                   "print a machine-readable summary on standard output, also of failures");
  command.add_flag("-q,--quiet", options.quiet,
                   "print nothing but errors (and what --json asks for)");
  command
      .add_option_function<unsigned>(
          "--threads", [&options](const unsigned& n) { options.threads = n; },
          "use at most N threads (default: one for each processor)")
      ->check(CLI::Range(1u, 4096u))
      ->type_name("N");
}

void add_validate(CLI::App& command, Options& options, const std::string& help) {
  command.add_flag("--validate", options.validate, help);
}

void add_repair(CLI::App& command, Options& options) {
  command.add_flag("--repair", options.repair,
                   "take each operand as the solid that its winding numbers say, wherever its "
                   "faces cross or overlap, and tell what was done (see sectile repair)");
}

void add_input_format(CLI::App& command, Options& options) {
  add_format(command, "--input-format", options.input_format,
             "format of standard input (-; default: obj) and of inputs whose extension is unknown: "
             "obj, stl, off, ply or 3mf; text and binary are told apart by content");
}

void add_rounding(CLI::App& command, Options& options) {
  command
      .add_option_function<double>(
          "--max-move", [&options](const double& d) { options.max_move = d; },
          "no corner may move farther when coordinates are rounded; if that cannot be, nothing is "
          "written (default: any distance, always the least that leaves a legal solid)")
      ->check(CLI::NonNegativeNumber)
      ->type_name("DISTANCE");
  command.add_flag("--separate-touching", options.separate_touching,
                   "move what touches in a vertex or an edge only apart by a step of the file's "
                   "numbers or a few, so that the mesh is a manifold");
}

void add_output_format(CLI::App& command, Options& options) {
  add_format(command, "--output-format", options.output_format,
             "format of the output whatever its extension (default for -: obj): "
             "obj, stl (binary), stl-text, off, ply (text), ply-binary or 3mf");
}

}  // namespace sectile::cli
