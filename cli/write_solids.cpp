#include "write_solids.h"

#include <algorithm>

#include "input.h"
#include "output.h"
#include "sectile/rounding.h"

namespace sectile::cli {
namespace {

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
      const std::string part = part_name(solids[i].name, i, solids.size());
      RoundedMesh rounded = round(part.empty() ? name : name + "#" + part, solid, format);
      written.push_back({name, solid, rounded.mesh.face_sizes.size(), rounded.report, part});
      model.meshes.push_back({solids[i].name, std::move(rounded.mesh)});
    }
    outputs.push_back(rendered(name, model, options_));
  }

  std::vector<Written> written;
  std::vector<Output> outputs;

 private:
  RoundedMesh round(const std::string& name, const Solid& solid, FileFormat format) const {
    Rounding rounding;
    rounding.numbers = numbers_of(format);
    rounding.separate_touching = options_.separate_touching;
    if (options_.max_move) rounding.max_move = *options_.max_move;
    rounding.progress = [&](double done) { progress_.fraction(done); };
    try {
      RoundedMesh rounded = rounded_mesh(solid, rounding);
      if (rounded.mesh.face_sizes.empty() && !solid.is_empty())
        throw RoundingFailed("the solid is too thin for the numbers of the file, nothing is left",
                             solid.to_mesh().positions.front());
      return rounded;
    } catch (const RoundingFailed& error) {
      throw RoundingFailed(name + ": cannot be written: " + error.what(), error.where());
    }
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
  return {{name, solid, triangles, {}, {}}};
}

}  // namespace sectile::cli
