// sectile union | intersect | subtract
#include <memory>

#include "arguments.h"
#include "careful_work.h"
#include "command.h"
#include "fold.h"
#include "input.h"
#include "output.h"

namespace sectile::cli {
namespace {

struct Words {
  const char *name, *description;
};

Words words_for(Operation operation) {
  switch (operation) {
    case Operation::unite:
      return {"union", "The union of all operands"};
    case Operation::intersect:
      return {"intersect", "The intersection of all operands"};
    case Operation::subtract:
      break;
  }
  return {"subtract", "The first operand minus all others"};
}

struct Arguments {
  std::vector<std::string> operands;
  std::string output;
};

ExitCode run(const Arguments& arguments, Operation operation, const Options& options) {
  check_inputs(arguments.operands);
  check_mesh_outputs({arguments.output}, options);
  Progress progress(!options.quiet);
  const Operands operands = read_operands(arguments.operands, options, progress);

  progress.stage(words_for(operation).name);
  const auto written = compute_and_write(
      operands, {arguments.output}, options, progress, [&](const BooleanOptions& how) {
        return std::vector<Solid>{fold(operands.solids, operation, how)};
      });
  report(words_for(operation).name, arguments.operands, written, options);
  return ExitCode::done;
}

}  // namespace

Command add_boolean_command(CLI::App& program, Operation operation, Options& options) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* app = add_command(program, words_for(operation).name, words_for(operation).description);
  add_texts(*app, "operands", arguments->operands, 2, any_number,
            "files of two or more solids; - is standard input", "A B...");
  add_text(*app, "-o,--output", arguments->output, "file of the result; - is standard output", "C");
  add_input_format(*app, options);
  add_output_format(*app, options);
  add_repair(*app, options);
  add_rounding(*app, options);
  add_validate(*app, options, "check all invariants after every phase, and the results");
  add_reporting(*app, options);
  return {app, [=, &options] { return run(*arguments, operation, options); }};
}

}  // namespace sectile::cli
