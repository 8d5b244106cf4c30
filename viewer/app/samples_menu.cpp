#include "app/samples_menu.h"

#include "samples/samples.h"

namespace sectile::viewer {
namespace {

NodeId add_mesh(Scene& scene, const char* name, const PolygonMesh& mesh) {
  Node node;
  node.name = name;
  node.what = Imported{{}, std::make_shared<const PolygonMesh>(mesh)};
  return scene.add(std::move(node));
}

}  // namespace

const std::vector<SampleTitle>& sample_titles() {
  static const std::vector<SampleTitle> titles = [] {
    std::vector<SampleTitle> made;
    for (const samples::Sample& sample : samples::all())
      made.push_back({sample.name, sample.title, sample.figure});
    return made;
  }();
  return titles;
}

Scene sample_scene(const std::string& name) {
  const samples::Sample sample = samples::get(name);
  Scene scene;
  const NodeId a = add_mesh(scene, "A", sample.a_mesh);
  if (sample.plane) {
    scene.split(a, *sample.plane);
  } else {
    const NodeId b = add_mesh(scene, "B", sample.b_mesh);
    scene.combine({a, b}, sample.operation.value_or(Operation::unite));
  }
  return scene;
}

}  // namespace sectile::viewer
