#include "write_solids.h"

#include <algorithm>
#include <sstream>

#include "degenerate.h"
#include "input.h"
#include "output.h"

namespace sectile::cli {
namespace {

// Exact points are rounded when they are written, and that can fold or cross faces.
std::optional<Problem> problem_of_rounding(const PolygonMesh& mesh) {
  try {
    Solid::from_mesh(mesh);
    return {};
  } catch (const InvalidSolid& error) {
    return problems_of(error).front();
  }
}

class SolidWriter {
 public:
  SolidWriter(const Options& options, Progress& progress)
      : options_(options), progress_(progress) {}

  /// What the file `name` will hold.
  void add(const std::string& name, const std::vector<NamedSolid>& solids, LengthUnit unit) {
    const FileFormat format = output_format(name, options_);
    Model model{unit, {}};
    for (std::size_t i = 0; i < solids.size(); ++i) {
      progress_.stage("writing " + name);
      const Solid& solid = solids[i].solid;
      PolygonMesh mesh = solid.to_mesh();
      const std::size_t triangles = mesh.face_sizes.size();
      written.push_back({name,
                         solid,
                         triangles,
                         count_degenerate_triangles(mesh, format),
                         {},
                         part_name(solids[i].name, i, solids.size())});
      model.meshes.push_back({solids[i].name, std::move(mesh)});
    }
    outputs.push_back(rendered(name, model, options_));
    if (options_.validate) validate_last(solids.size());
  }

  std::vector<Written> written;
  std::vector<Output> outputs;

 private:
  void validate_last(std::size_t solids) {
    const auto& [name, content] = outputs.back();
    std::istringstream file(content);
    const Model model = read_model(file, output_format(name, options_), name);
    Written* const first = &written[written.size() - solids];
    for (std::size_t i = 0; i < solids; ++i)
      first[i].problem = problem_of_rounding(model.meshes[i].mesh);
  }

  const Options& options_;
  Progress& progress_;
};

}  // namespace

std::vector<Written> write_solids(const std::vector<std::string>& names,
                                  const std::vector<Solid>& solids, LengthUnit unit,
                                  const Options& options, Progress& progress) {
  SolidWriter writer(options, progress);
  for (std::size_t i = 0; i < names.size(); ++i) writer.add(names[i], {{{}, solids[i]}}, unit);
  write_outputs(writer.outputs);
  return writer.written;
}

std::vector<Written> write_parts(const std::string& name, const std::vector<NamedSolid>& solids,
                                 LengthUnit unit, const Options& options, Progress& progress) {
  SolidWriter writer(options, progress);
  writer.add(name, solids, unit);
  write_outputs(writer.outputs);
  return writer.written;
}

std::vector<Written> write_faces(const std::string& name, const Solid& solid,
                                 const PolygonMesh& mesh, const Options& options) {
  const Output output = rendered(name, {LengthUnit::millimeter, {{{}, mesh}}}, options);
  write_outputs({output});
  const auto triangles = static_cast<std::size_t>(
      std::count(mesh.face_sizes.begin(), mesh.face_sizes.end(), std::uint32_t{3}));
  return {{name, solid, triangles, 0, {}, {}}};
}

}  // namespace sectile::cli
