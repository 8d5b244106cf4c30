#include "samples/samples.h"

#include <stdexcept>

#include "samples/lists.h"

namespace sectile::samples {

Sample pair_sample(const char* name, const char* title, const char* figure, Operation operation,
                   const PolygonMesh& a, const PolygonMesh& b) {
  Sample sample;
  sample.name = name;
  sample.title = title;
  sample.figure = figure;
  sample.a_mesh = a;
  sample.b_mesh = b;
  sample.a = Solid::from_mesh(a);
  sample.b = Solid::from_mesh(b);
  sample.operation = operation;
  return sample;
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
