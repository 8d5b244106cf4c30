// Options that several commands share, so that they mean the same everywhere.
#pragma once

#include <optional>
#include <string>

#include "sectile/files.h"

namespace CLI {
class App;
}

namespace sectile::cli {

struct Options {
  bool json = false;
  bool quiet = false;
  bool validate = false;
  bool repair = false;
  bool separate_touching = false;
  std::optional<unsigned> threads;
  std::optional<double> max_move;
  std::optional<FileFormat> input_format, output_format;
};

/// --json, --quiet and --threads.
void add_reporting(CLI::App& command, Options& options);
void add_validate(CLI::App& command, Options& options, const std::string& help);
void add_repair(CLI::App& command, Options& options);
void add_input_format(CLI::App& command, Options& options);
void add_output_format(CLI::App& command, Options& options);
/// --max-move and --separate-touching.
void add_rounding(CLI::App& command, Options& options);

}  // namespace sectile::cli
