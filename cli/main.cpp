// sectile: exact Booleans of solids in files.
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <optional>

#include "exit_codes.h"
#include "inputs.h"
#include "options.h"

namespace sectile::cli {
namespace {

class CommandLine {
 public:
  CommandLine() {
    app_.require_subcommand(1);
    app_.set_version_flag("--version", "sectile " SECTILE_VERSION);
    app_.footer(
        "Examples:\n"
        "  sectile union bracket.obj rib.obj -o part.obj\n"
        "  sectile subtract block.stl hole1.stl hole2.stl -o drilled.stl\n"
        "  sectile split part.off --plane 0,0,1,-5 -o above.off below.off\n"
        "  sectile check part.ply\n"
        "Exit: 0 done, 1 not a legal solid, 2 wrong usage, 3 file trouble, 4 internal error,\n"
        "      5 interrupted. An output file appears whole or not at all.");
    add_boolean("union", "All points of any of the solids", Operation::unite);
    add_boolean("intersect", "The points that all solids have in common", Operation::intersect);
    add_boolean("subtract", "The first solid without the others", Operation::subtract);
    CLI::App* split = add("split", "The parts of a solid above and below a plane", 1, 2,
                          [this] { return run_split(options_); });
    split->add_option("--plane", options_.plane, "a,b,c,d: above is where ax + by + cz + d >= 0")
        ->delimiter(',')
        ->required();
    add("check", "Is the file a legal solid, and if not, where?", 1, 0,
        [this] { return run_check(options_); });
    add("info", "Counts, volume and area of a solid", 1, 0, [this] { return run_info(options_); });
    add("convert", "The same mesh in another format", 1, 1,
        [this] { return run_convert(options_); });
    CLI::App* trace = add("trace", "What each phase of an operation does, as JSON", 2, 1,
                          [this] { return run_trace(options_); });
    trace->add_option("--op", options_.operation, "union, intersect or subtract")
        ->check(CLI::IsMember({"union", "intersect", "subtract"}))
        ->capture_default_str();
  }

  int run(int argc, char** argv) {
    try {
      app_.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      return app_.exit(error) == 0 ? done : wrong_usage;
    }
    std::optional<tbb::global_control> limit;
    if (options_.threads > 0)
      limit.emplace(tbb::global_control::max_allowed_parallelism,
                    static_cast<std::size_t>(options_.threads));
    return command_();
  }

 private:
  CLI::App* add(const std::string& name, const std::string& help, int inputs, int outputs,
                std::function<int()> command) {
    CLI::App* sub = app_.add_subcommand(name, help);
    CLI::Option* in = sub->add_option("files", options_.inputs,
                                      "Input (.obj, .stl, .off, .ply, or - for standard input)");
    in->required();
    if (inputs > 0)
      in->expected(inputs);
    else
      in->expected(2, 1 << 20);
    if (outputs > 0)
      sub->add_option("-o,--output", options_.outputs,
                      "Output, format by extension, or - for standard output")
          ->required()
          ->expected(outputs);
    sub->add_option("--format", options_.format, "Format of standard input and output")
        ->check(CLI::IsMember({"obj", "stl", "off", "ply"}))
        ->capture_default_str();
    sub->add_option("--threads", options_.threads, "Number of threads (0: all cores)")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    sub->add_flag("--json", options_.json, "Say what was made as JSON");
    sub->add_flag("--quiet", options_.quiet, "Say nothing but errors");
    sub->add_flag("--validate", options_.validate, "Check all invariants after every phase");
    sub->callback([this, command] { command_ = command; });
    return sub;
  }

  void add_boolean(const std::string& name, const std::string& help, Operation operation) {
    add(name, help, 0, 1, [this, operation] { return run_boolean(options_, operation); });
  }

  CLI::App app_{"Exact Boolean operations on polyhedral solids", "sectile"};
  Options options_;
  std::function<int()> command_;
};

int guarded(int argc, char** argv) {
  try {
    return CommandLine().run(argc, argv);
  } catch (const BadInput& error) {
    std::cerr << error.what() << '\n';
    return not_a_solid;
  } catch (const FileError& error) {
    std::cerr << error.what() << '\n';
    return file_trouble;
  } catch (const std::invalid_argument& error) {
    std::cerr << error.what() << '\n';
    return wrong_usage;
  } catch (const Cancelled&) {
    std::cerr << "interrupted; nothing was written\n";
    return cancelled;
  } catch (const InternalError& error) {
    std::cerr << "internal error: " << error.what()
              << "\nIf `sectile check` finds the inputs legal, please report this.\n";
    return internal;
  } catch (const std::bad_alloc&) {
    std::cerr << "out of memory\n";
    return internal;
  }
}

}  // namespace
}  // namespace sectile::cli

int main(int argc, char** argv) {
  return sectile::cli::guarded(argc, argv);
}
