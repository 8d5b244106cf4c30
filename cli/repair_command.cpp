// sectile repair
#include <iostream>
#include <memory>

#include "arguments.h"
#include "command.h"
#include "input.h"
#include "json.h"
#include "output.h"
#include "repairing.h"
#include "sectile/repair.h"
#include "summary.h"
#include "write_solids.h"

namespace sectile::cli {
namespace {

struct Arguments {
  std::vector<std::string> inputs;
  std::string output;
  RepairOptions how;
  bool dry_run = false;
};

using cli::to_json;

Json to_json(const Vec3& p) {
  return Json::array({p.x, p.y, p.z});
}

Json to_json(const RepairReport& report) {
  Json changes = Json::array(), holes = Json::array();
  for (const RepairChange& change : report.changes) {
    Json json{{"kind", name_of(change.kind)},
              {"count", change.count},
              {"message", in_words(change)},
              {"where", to_json(change.where)}};
    if (change.face != no_element) json["face"] = change.face;
    changes.push_back(json);
  }
  for (const Hole& hole : report.holes)
    holes.push_back(Json{{"edges", hole.edges},
                         {"length", hole.length},
                         {"where", to_json(hole.where)},
                         {"face", hole.face}});
  return Json{{"changes", changes}, {"holes", holes}};
}

void print(const RepairReport& report) {
  if (report.changes.empty()) std::cout << "nothing to repair\n";
  for (const RepairChange& change : report.changes) std::cout << in_words(change) << '\n';
  for (const Hole& hole : report.holes)
    std::cout << "  hole of " << counted(hole.edges, "edge") << ", length " << in_words(hole.length)
              << ", at (" << in_words(hole.where.x) << ", " << in_words(hole.where.y) << ", "
              << in_words(hole.where.z) << "), face " << hole.face << '\n';
}

void print_json(const Arguments& arguments, const RepairReport& report, const Solid& solid,
                const std::vector<Written>& written) {
  Json json{{"command", "repair"},
            {"exit_code", 0},
            {"inputs", arguments.inputs},
            {"dry_run", arguments.dry_run}};
  json.update(to_json(report));
  json["result"] = to_json(solid);
  json["outputs"] = Json::array();
  for (const Written& w : written) json["outputs"].push_back(to_json(w));
  std::cout << json.dump() << '\n';
}

ExitCode run(const Arguments& arguments, const Options& options) {
  check_inputs(arguments.inputs);
  if (arguments.output.empty() && !arguments.dry_run)
    throw UsageError("where is the result to go? Give -o OUT, or --dry-run");
  if (!arguments.dry_run) check_mesh_outputs({arguments.output}, options);
  Progress progress(!options.quiet);
  PolygonMesh all;
  LengthUnit unit = LengthUnit::millimeter;
  for (const std::string& name : arguments.inputs) {
    progress.stage("reading " + name);
    const Model model = read_input(name, options);
    append(all, joined(model, name));
    if (input_format(name, options) == FileFormat::three_mf) unit = model.unit;
  }
  progress.stage("repairing");
  RepairOptions how = arguments.how;
  how.progress = [&](double done) { progress.fraction(done); };
  RepairReport report;
  const Solid solid = repair_input(arguments.inputs.front(), all, how, report);
  std::vector<Written> written;
  if (!arguments.dry_run)
    written = write_solids({arguments.output}, {solid}, unit, options, progress);
  if (options.json) {
    print_json(arguments, report, solid, written);
  } else if (!options.quiet && arguments.output != "-") {
    print(report);
    for (const Written& w : written) std::cout << in_words(w) << '\n';
  }
  return ExitCode::done;
}

}  // namespace

Command add_repair_command(CLI::App& program, Options& options) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* app = add_command(
      program, "repair",
      "The solid that the faces of all inputs together bound, wherever they cross or overlap");
  add_texts(*app, "inputs", arguments->inputs, 1, any_number,
            "files of meshes; - is standard input", "IN...");
  add_optional_text(*app, "-o,--output", arguments->output, "file to write; - is standard output",
                    "OUT");
  add_rule(*app, "--rule", arguments->how.rule,
           "what is material: where the surface goes around a point in the positive sense, at all, "
           "or an odd number of times (needs no orientation)");
  add_switch(*app, "--close-holes", arguments->how.close_holes,
             "close holes with triangles between their corners");
  add_length(*app, "--stitch", arguments->how.stitch,
             "unite vertices on borders that are at most this far from each other", "DISTANCE");
  add_switch(*app, "--dry-run", arguments->dry_run, "say what would be done, write nothing");
  add_input_format(*app, options);
  add_output_format(*app, options);
  add_rounding(*app, options);
  add_validate(*app, options, "check also the file written");
  add_reporting(*app, options);
  return {app, [=, &options] { return run(*arguments, options); }};
}

}  // namespace sectile::cli
