// Writes the operands of all samples as NAME-a.obj and NAME-b.obj into a folder.
#include <cstdio>
#include <exception>
#include <filesystem>

#include "samples/samples.h"
#include "sectile/files.h"

namespace {

void write_operand(const std::filesystem::path& path, const sectile::PolygonMesh& mesh) {
  if (!mesh.face_sizes.empty()) sectile::write_mesh(path, mesh);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: sectile_make_samples FOLDER\n");
    return 2;
  }
  try {
    const std::filesystem::path folder = argv[1];
    std::filesystem::create_directories(folder);
    for (const sectile::samples::Sample& sample : sectile::samples::all()) {
      write_operand(folder / (sample.name + "-a.obj"), sample.a_mesh);
      write_operand(folder / (sample.name + "-b.obj"), sample.b_mesh);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sectile_make_samples: %s\n", error.what());
    return 3;
  }
}
