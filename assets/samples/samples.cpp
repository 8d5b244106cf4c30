#include "samples/samples.h"

#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "samples/lists.h"

namespace sectile::samples {

Solid solid_of(const PolygonMesh& mesh) {
  std::vector<std::uint32_t> each(mesh.face_sizes.size());
  std::iota(each.begin(), each.end(), 0u);
  ImportOptions apart;
  apart.face_groups = each;
  return Solid::from_mesh(mesh, apart);
}

Sample pair_sample(const char* name, const char* title, const char* figure, Operation operation,
                   const PolygonMesh& a, const PolygonMesh& b) {
  return {.name = name,
          .title = title,
          .figure = figure,
          .a_mesh = a,
          .b_mesh = b,
          .a = solid_of(a),
          .b = solid_of(b),
          .operation = operation,
          .plane = {}};
}

std::vector<Sample> all() {
  std::vector<Sample> samples = overview_figures();
  for (const auto& list : {coincidence_figures(), sequence_figures()})
    samples.insert(samples.end(), list.begin(), list.end());
  return samples;
}

Sample get(const std::string& name) {
  for (Sample& sample : all())
    if (sample.name == name) return sample;
  throw std::out_of_range("There is no sample called \"" + name + "\".");
}

}  // namespace sectile::samples
