// sectile split
#include <charconv>
#include <cmath>
#include <memory>

#include "arguments.h"
#include "careful_work.h"
#include "command.h"
#include "input.h"
#include "output.h"

namespace sectile::cli {
namespace {

struct Arguments {
  std::string operand, plane;
  std::vector<std::string> outputs;
};

// Numbers are rounded correctly, as in files, so that planes meet the points they should.
HalfSpace plane_from(const std::string& text) {
  HalfSpace plane;
  const char *at = text.data(), *const end = at + text.size();
  for (double* coefficient : {&plane.a, &plane.b, &plane.c, &plane.d}) {
    if (coefficient != &plane.a && (at == end || *at++ != ','))
      throw UsageError("--plane needs four numbers a,b,c,d, not \"" + text + "\"");
    const auto [rest, error] = std::from_chars(at, end, *coefficient);
    if (error != std::errc() || !std::isfinite(*coefficient))
      throw UsageError("--plane needs four finite numbers a,b,c,d, not \"" + text + "\"");
    at = rest;
  }
  if (at != end) throw UsageError("--plane needs no more than a,b,c,d, not \"" + text + "\"");
  if (plane.a == 0 && plane.b == 0 && plane.c == 0)
    throw UsageError("the normal (a,b,c) of --plane is zero");
  return plane;
}

ExitCode run(const Arguments& arguments, const Options& options) {
  const HalfSpace plane = plane_from(arguments.plane);
  check_inputs({arguments.operand});
  check_mesh_outputs(arguments.outputs, options);
  Progress progress(!options.quiet);
  const Operands operands = read_operands({arguments.operand}, options, progress);

  progress.stage("split");
  const auto written = compute_and_write(
      operands, arguments.outputs, options, progress, [&](const BooleanOptions& how) {
        const auto [above, below] = split(operands.solids.front(), plane, how);
        return std::vector<Solid>{above, below};
      });
  report("split", {arguments.operand}, written, options);
  return ExitCode::done;
}

}  // namespace

Command add_split_command(CLI::App& program, Options& options) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* app = add_command(program, "split", "The two parts of a solid on the sides of a plane");
  add_text(*app, "operand", arguments->operand, "file of the solid; - is standard input", "A");
  add_text(*app, "--plane", arguments->plane,
           "the plane ax + by + cz + d = 0; above it, ax + by + cz + d is positive", "a,b,c,d");
  add_texts(*app, "-o,--output", arguments->outputs, 2, 2,
            "files of the parts above and below; one of them may be -, standard output",
            "ABOVE BELOW");
  add_input_format(*app, options);
  add_output_format(*app, options);
  add_rounding(*app, options);
  add_validate(*app, options, "check all invariants after every phase, and the parts");
  add_reporting(*app, options);
  return {app, [=, &options] { return run(*arguments, options); }};
}

}  // namespace sectile::cli
