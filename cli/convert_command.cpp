// sectile convert
#include <memory>

#include "arguments.h"
#include "careful_work.h"
#include "command.h"
#include "input.h"
#include "output.h"
#include "write_solids.h"

namespace sectile::cli {
namespace {

struct Arguments {
  std::string input, output;
  bool keep_faces = false;
};

bool is_stl(FileFormat format) {
  return format == FileFormat::stl_text || format == FileFormat::stl_binary;
}

ExitCode run(const Arguments& arguments, const Options& options) {
  check_inputs({arguments.input});
  check_mesh_outputs({arguments.output}, options);
  if (arguments.keep_faces && is_stl(output_format(arguments.output, options)))
    throw UsageError("STL holds only triangles; leave --keep-faces out");
  Progress progress(!options.quiet);
  progress.stage("reading " + arguments.input);
  const PolygonMesh mesh = read_input(arguments.input, options);
  const Solid solid = import_input(arguments.input, mesh, options.validate);

  const Interrupt interrupt;
  std::vector<Written> written;
  blame_illegal_operands({{arguments.input}, {solid}}, [&] {
    written = arguments.keep_faces
                  ? write_faces(arguments.output, solid, mesh, options, interrupt)
                  : write_solids({arguments.output}, {solid}, options, progress, interrupt);
  });
  report("convert", {arguments.input}, written, options);
  return ExitCode::done;
}

}  // namespace

Command add_convert_command(CLI::App& program, Options& options) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* app = add_command(program, "convert", "The same solid in another format, as triangles");
  add_text(*app, "input", arguments->input, "file of the solid; - is standard input", "IN");
  add_text(*app, "-o,--output", arguments->output, "file to write; - is standard output", "OUT");
  add_switch(*app, "--keep-faces", arguments->keep_faces,
             "write positions and polygons as they were read, not triangles (not for STL)");
  add_input_format(*app, options);
  add_output_format(*app, options);
  add_validate(*app, options, "check also that no faces cross, and the file written");
  add_reporting(*app, options);
  return {app, [=, &options] { return run(*arguments, options); }};
}

}  // namespace sectile::cli
