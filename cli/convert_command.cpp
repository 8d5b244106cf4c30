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

bool holds_only_triangles(FileFormat format) {
  return format == FileFormat::stl_text || format == FileFormat::stl_binary ||
         format == FileFormat::three_mf;
}

// Each solid by itself, with its name.
std::vector<Written> convert_parts(const Arguments& arguments, const Model& model,
                                   const Options& options, Progress& progress) {
  Operands operands;
  std::vector<NamedSolid> parts;
  for (std::size_t i = 0; i < model.meshes.size(); ++i) {
    const NamedMesh& read = model.meshes[i];
    const std::string part = part_name(read.name, i, model.meshes.size());
    operands.names.push_back(arguments.input + (part.empty() ? "" : "#" + part));
    operands.solids.push_back(import_input(operands.names.back(), read.mesh, progress));
    parts.push_back({read.name, operands.solids.back()});
  }
  return write_parts(arguments.output, parts, model.unit, options, progress);
}

// Several solids become one, where the format holds no more.
std::vector<Written> convert_whole(const Arguments& arguments, const PolygonMesh& mesh,
                                   LengthUnit unit, const Options& options, Progress& progress) {
  const Solid solid = import_input(arguments.input, mesh, progress);
  return arguments.keep_faces ? write_faces(arguments.output, solid, mesh, options)
                              : write_solids({arguments.output}, {solid}, unit, options, progress);
}

ExitCode run(const Arguments& arguments, const Options& options) {
  check_inputs({arguments.input});
  check_mesh_outputs({arguments.output}, options);
  const FileFormat format = output_format(arguments.output, options);
  if (arguments.keep_faces && holds_only_triangles(format))
    throw UsageError("STL and 3MF hold only triangles; leave --keep-faces out");
  Progress progress(!options.quiet);
  progress.stage("reading " + arguments.input);
  const Model model = read_input(arguments.input, options);
  const auto written =
      format == FileFormat::three_mf
          ? convert_parts(arguments, model, options, progress)
          : convert_whole(arguments, joined(model, arguments.input), model.unit, options, progress);
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
             "write positions and polygons as they were read, not triangles (not for STL and 3MF)");
  add_input_format(*app, options);
  add_output_format(*app, options);
  add_rounding(*app, options);
  add_reporting(*app, options);
  return {app, [=, &options] { return run(*arguments, options); }};
}

}  // namespace sectile::cli
