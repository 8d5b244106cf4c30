// assets/scenes holds what sectile_make_samples writes.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "samples/samples.h"
#include "sectile/files.h"

namespace sectile {
namespace {

const std::filesystem::path folder = SECTILE_SCENES_FOLDER;

std::string content(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  EXPECT_TRUE(in.is_open()) << path;
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

void expect_written(const std::string& name, const PolygonMesh& mesh, const Solid& solid) {
  std::ostringstream expected;
  write_mesh(expected, FileFormat::obj, mesh, name);
  EXPECT_EQ(content(folder / name), expected.str()) << "run sectile_make_samples assets/scenes";
  EXPECT_TRUE(Solid::from_mesh(read_mesh(folder / name)) == solid) << name;
}

TEST(SceneFiles, AreUpToDate) {
  std::set<std::string> expected, found;
  for (const samples::Sample& sample : samples::all()) {
    expected.insert(sample.name + "-a.obj");
    expect_written(sample.name + "-a.obj", sample.a_mesh, sample.a);
    if (sample.b.is_empty()) continue;
    expected.insert(sample.name + "-b.obj");
    expect_written(sample.name + "-b.obj", sample.b_mesh, sample.b);
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    found.insert(entry.path().filename().string());
  EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace sectile
