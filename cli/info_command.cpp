// sectile info: what is in a file, legal or not.
#include <algorithm>
#include <iostream>
#include <memory>

#include "arguments.h"
#include "command.h"
#include "file_formats.h"
#include "input.h"
#include "json.h"
#include "summary.h"

namespace sectile::cli {
namespace {

struct Box {
  Vec3 low, high;
};

struct MeshFacts {
  std::size_t positions = 0, faces = 0, triangles = 0, quadrilaterals = 0, larger = 0;
  std::uint32_t most_corners = 0;
  Box box;
};

void extend(Box& box, const Vec3& p) {
  box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
  box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
}

MeshFacts facts_of(const PolygonMesh& mesh) {
  MeshFacts facts;
  facts.positions = mesh.positions.size();
  facts.faces = mesh.face_sizes.size();
  for (const std::uint32_t size : mesh.face_sizes) {
    ++(size == 3 ? facts.triangles : size == 4 ? facts.quadrilaterals : facts.larger);
    facts.most_corners = std::max(facts.most_corners, size);
  }
  if (!mesh.positions.empty()) facts.box = {mesh.positions.front(), mesh.positions.front()};
  for (const Vec3& p : mesh.positions) extend(facts.box, p);
  return facts;
}

std::string in_words(const Vec3& p) {
  return "(" + cli::in_words(p.x) + ", " + cli::in_words(p.y) + ", " + cli::in_words(p.z) + ")";
}

void print_facts(const std::string& name, const std::string& kind, const MeshFacts& facts) {
  std::cout << name << ": " << kind << '\n'
            << "  " << counted(facts.positions, "position") << ", " << counted(facts.faces, "face")
            << " (" << counted(facts.triangles, "triangle") << ", "
            << counted(facts.quadrilaterals, "quadrilateral") << ", " << facts.larger
            << " larger; at most " << counted(facts.most_corners, "corner") << ")\n";
  if (facts.positions > 0)
    std::cout << "  from " << in_words(facts.box.low) << " to " << in_words(facts.box.high) << '\n';
}

void print_solid(const Solid& solid) {
  const SolidCounts counts = solid.counts();
  std::cout << "  a solid of " << counted(counts.vertices, "vertex", "vertices") << ", "
            << counted(counts.edges, "edge") << ", " << counted(counts.faces, "face") << ", "
            << counted(counts.shells, "shell") << ", genus " << counts.genus << ", volume "
            << cli::in_words(solid.volume()) << ", area " << cli::in_words(solid.area()) << '\n';
}

Json json_of(const std::string& name, const std::string& kind, const MeshFacts& facts) {
  Json json{{"command", "info"},
            {"exit_code", 0},
            {"file", name},
            {"format", kind},
            {"positions", facts.positions},
            {"faces", facts.faces},
            {"triangles", facts.triangles},
            {"quadrilaterals", facts.quadrilaterals},
            {"larger_faces", facts.larger},
            {"most_corners", facts.most_corners}};
  const auto& [low, high] = facts.box;
  if (facts.positions > 0)
    json["box"] = {{"low", {low.x, low.y, low.z}}, {"high", {high.x, high.y, high.z}}};
  return json;
}

// Text and binary files of a kind are told apart by content, so this names only the kind.
std::string kind_of(FileFormat format) {
  const std::string& name = name_of(format);
  return name.substr(0, name.find('-'));
}

class Description {
 public:
  Description(const std::string& name, const Options& options, Progress& progress)
      : name_(name),
        options_(options),
        progress_(progress),
        in_words_(!options.json && !options.quiet) {}

  void run(const Model& model) {
    const FileFormat format = input_format(name_, options_);
    const MeshFacts facts = facts_of(joined(model, name_));
    Json json = json_of(name_, kind_of(format), facts);
    if (in_words_) print_facts(name_, kind_of(format), facts);
    if (format == FileFormat::three_mf) {
      json["unit"] = name_of(model.unit);
      if (in_words_) std::cout << "  unit: " << name_of(model.unit) << '\n';
      json["solids"] = Json::array();
      for (std::size_t i = 0; i < model.meshes.size(); ++i)
        json["solids"].push_back(one_of_several(model.meshes[i], i));
    } else {
      add_solid(json, name_, model.meshes.front().mesh);
    }
    if (options_.json) std::cout << json.dump() << '\n';
  }

 private:
  Json one_of_several(const NamedMesh& part, std::size_t index) const {
    Json json{{"number", index + 1},
              {"name", part.name},
              {"positions", part.mesh.positions.size()},
              {"faces", part.mesh.face_sizes.size()}};
    if (in_words_)
      std::cout << "  " << index + 1 << ": " << (part.name.empty() ? "without a name" : part.name)
                << '\n';
    add_solid(json, part.name, part.mesh);
    return json;
  }

  void add_solid(Json& json, const std::string& name, const PolygonMesh& mesh) const {
    try {
      const Solid solid = import_input(name, mesh, progress_);
      json["solid"] = to_json(solid);
      if (in_words_) print_solid(solid);
    } catch (const IllegalInput& error) {
      const Problem& problem = error.problems().front();
      json["solid"] = nullptr;
      json["problem"] = to_json(problem);
      if (in_words_) std::cout << "  not a legal solid: " << cli::in_words(problem) << '\n';
    }
  }

  const std::string& name_;
  const Options& options_;
  Progress& progress_;
  bool in_words_;
};

ExitCode run(const std::string& name, const Options& options) {
  check_inputs({name});
  Progress progress(!options.quiet);
  progress.stage("reading " + name);
  Description(name, options, progress).run(read_input(name, options));
  return ExitCode::done;
}

}  // namespace

Command add_info_command(CLI::App& program, Options& options) {
  const auto name = std::make_shared<std::string>();
  CLI::App* app =
      add_command(program, "info",
                  "What a file holds: format, faces, extent, and the solid they bound, if they do");
  add_text(*app, "file", *name, "file to describe; - is standard input", "FILE");
  add_input_format(*app, options);
  add_reporting(*app, options);
  return {app, [=, &options] { return run(*name, options); }};
}

}  // namespace sectile::cli
