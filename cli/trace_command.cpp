// sectile trace
#include "sectile/trace.h"

#include <iostream>
#include <memory>
#include <sstream>

#include "arguments.h"
#include "careful_work.h"
#include "command.h"
#include "input.h"
#include "json.h"
#include "output.h"
#include "problem.h"

namespace sectile::cli {
namespace {

struct Arguments {
  std::vector<std::string> operands;
  Operation operation = Operation::unite;
  std::string output;
};

ExitCode run(const Arguments& arguments, const Options& options) {
  check_inputs(arguments.operands);
  check_outputs({arguments.output}, options);
  Progress progress(!options.quiet);
  const Operands operands = read_operands(arguments.operands, options, progress);
  progress.stage("trace");
  std::ostringstream out;
  out.exceptions(std::ios::badbit);  // a stream would hide that memory ran out
  write_trace(out, operands.solids[0], operands.solids[1], arguments.operation);
  const std::string trace = std::move(out).str();
  write_outputs({{arguments.output, trace}});
  if (options.json)
    std::cout << Json{{"command", "trace"},
                      {"exit_code", 0},
                      {"inputs", arguments.operands},
                      {"output", arguments.output},
                      {"bytes", trace.size()}}
                     .dump()
              << '\n';
  else if (!options.quiet && !uses_standard_output({arguments.output}))
    std::cout << arguments.output << ": trace of the operation, " << trace.size() << " bytes\n";
  return ExitCode::done;
}

}  // namespace

Command add_trace_command(CLI::App& program, Options& options) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* app =
      add_command(program, "trace", "What every phase of an operation finds and does, as JSON");
  add_texts(*app, "operands", arguments->operands, 2, 2, "files of two solids; - is standard input",
            "A B");
  add_operation(*app, "--op", arguments->operation, "the operation: union, intersect or subtract");
  add_text(*app, "-o,--output", arguments->output, "file of the trace; - is standard output",
           "T.json");
  add_input_format(*app, options);
  add_reporting(*app, options);
  return {app, [=, &options] { return run(*arguments, options); }};
}

}  // namespace sectile::cli
