// sectile check
#include <iostream>
#include <memory>

#include "arguments.h"
#include "command.h"
#include "input.h"
#include "json.h"
#include "summary.h"

namespace sectile::cli {
namespace {

void print_legal(const std::string& name, const Solid& solid) {
  const SolidCounts counts = solid.counts();
  std::cout << name << ": a legal solid" << (solid.is_empty() ? ", empty" : "") << '\n'
            << "  " << counted(counts.vertices, "vertex", "vertices") << ", "
            << counted(counts.edges, "edge") << ", " << counted(counts.faces, "face") << ", "
            << counted(counts.loops, "loop") << ", " << counted(counts.shells, "shell")
            << ", genus " << counts.genus << '\n'
            << "  volume " << in_words(solid.volume()) << ", area " << in_words(solid.area())
            << '\n';
}

void print_json(const std::string& name, const Solid& solid) {
  Json json{{"command", "check"}, {"exit_code", 0}, {"file", name}, {"legal", true}};
  json.update(to_json(solid));
  std::cout << json.dump() << '\n';
}

void print_json(const IllegalInput& error) {
  Json problems = Json::array();
  for (const Problem& problem : error.problems()) problems.push_back(to_json(problem));
  const Json json{{"command", "check"},
                  {"exit_code", static_cast<int>(ExitCode::not_legal)},
                  {"file", error.file()},
                  {"legal", false},
                  {"problems", problems}};
  std::cout << json.dump() << '\n';
}

ExitCode run(const std::string& name, const Options& options) {
  check_inputs({name});
  Progress progress(!options.quiet);
  progress.stage("reading " + name);
  const PolygonMesh mesh = joined(read_input(name, options), name);
  progress.stage("checking " + name);
  try {
    const Solid solid = import_input(name, mesh, progress);
    if (options.json)
      print_json(name, solid);
    else if (!options.quiet)
      print_legal(name, solid);
    return ExitCode::done;
  } catch (const IllegalInput& error) {
    std::cerr << "sectile: " << error.what() << '\n';
    if (options.json) print_json(error);
    return ExitCode::not_legal;
  }
}

}  // namespace

Command add_check_command(CLI::App& program, Options& options) {
  const auto name = std::make_shared<std::string>();
  CLI::App* app =
      add_command(program, "check",
                  "Is it a legal solid, and if not, where? Its volume, area, shells and genus");
  add_text(*app, "file", *name, "file to check; - is standard input", "FILE");
  add_input_format(*app, options);
  add_reporting(*app, options);
  return {app, [=, &options] { return run(*name, options); }};
}

}  // namespace sectile::cli
