#include "write_solids.h"

#include <algorithm>
#include <sstream>

#include "degenerate.h"
#include "input.h"
#include "output.h"

namespace sectile::cli {
namespace {

// Exact points are rounded when they are written, and that can fold or cross faces.
std::optional<Problem> problem_of_rounding(const Output& output, const Options& options) {
  std::istringstream file(output.content);
  const PolygonMesh mesh = read_mesh(file, output_format(output.name, options), output.name);
  try {
    import_input(output.name, mesh, true);
    return {};
  } catch (const IllegalInput& error) {
    return error.problems().front();
  }
}

}  // namespace

std::vector<Written> write_solids(const std::vector<std::string>& names,
                                  const std::vector<Solid>& solids, const Options& options,
                                  Progress& progress, const Interrupt& interrupt) {
  std::vector<Written> written;
  std::vector<Output> outputs;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string& name = names[i];
    const Solid& solid = solids[i];
    progress.stage("writing " + name);
    const PolygonMesh mesh = solid.to_mesh();
    written.push_back({name,
                       solid,
                       mesh.face_sizes.size(),
                       count_degenerate_triangles(mesh, output_format(name, options)),
                       {}});
    outputs.push_back(rendered(name, mesh, options));
    if (options.validate) written.back().problem = problem_of_rounding(outputs.back(), options);
    interrupt.check();
  }
  write_outputs(outputs);
  return written;
}

std::vector<Written> write_faces(const std::string& name, const Solid& solid,
                                 const PolygonMesh& mesh, const Options& options,
                                 const Interrupt& interrupt) {
  const Output output = rendered(name, mesh, options);
  interrupt.check();
  write_outputs({output});
  const auto triangles = static_cast<std::size_t>(
      std::count(mesh.face_sizes.begin(), mesh.face_sizes.end(), std::uint32_t{3}));
  return {{name, solid, triangles, 0, {}}};
}

}  // namespace sectile::cli
