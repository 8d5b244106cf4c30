// The program without a display: what cannot be drawn is an error, told in words and by exit code.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "render/renderer.h"
#include "sectile/sectile.h"

namespace sectile::viewer {
namespace {

namespace fs = std::filesystem;

struct Outcome {
  int code = -1;
  std::string told;
};

class ViewerProgram : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / ("sectile_viewer_" + std::string(test->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    write_mesh(folder_ / "a.obj", block({0, 0, 0}, {2, 2, 2}).to_mesh());
    write_mesh(folder_ / "b.stl", block({1, 1, 1}, {3, 3, 3}).to_mesh());
  }
  void TearDown() override { fs::remove_all(folder_); }

  Outcome run(const std::string& arguments) {
    const std::string command = "cd '" + folder_.string() +
                                "' && env -u DISPLAY -u WAYLAND_DISPLAY " + SECTILE_VIEWER_PROGRAM +
                                " " + arguments + " 2>&1";
    Outcome outcome;
    FILE* pipe = popen(command.c_str(), "r");
    if (!pipe) return outcome;
    for (int c = fgetc(pipe); c != EOF; c = fgetc(pipe)) outcome.told += static_cast<char>(c);
    const int status = pclose(pipe);
    outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return outcome;
  }

  /// Nothing is drawn, and what is wrong is said.
  void expect_refused(const std::string& arguments, int code, const std::string& reason) {
    const Outcome outcome = run(arguments + " --size 160x120");
    EXPECT_EQ(outcome.code, code) << arguments << ": " << outcome.told;
    EXPECT_NE(outcome.told.find(reason), std::string::npos) << arguments << ": " << outcome.told;
    for (const auto& entry : fs::directory_iterator(folder_))
      EXPECT_NE(entry.path().extension(), ".png") << arguments;
  }

  fs::path folder_;
};

TEST_F(ViewerProgram, DrawsFilesWithoutADisplay) {
  const Outcome outcome = run("a.obj b.stl --size 320x240 --screenshot both.png");
  EXPECT_EQ(outcome.code, 0) << outcome.told;
  EXPECT_EQ(read_png((folder_ / "both.png").string()).width, 320);
}

TEST_F(ViewerProgram, MissingFilesAreErrors) {
  expect_refused("--scene none.sectile --screenshot x.png", 3, "none.sectile");
  expect_refused("a.obj none.obj --screenshot x.png", 3, "none.obj");
  expect_refused("none.obj", 3, "none.obj");
  expect_refused("a.obj none.obj --no-interface --screenshot x.png", 3, "none.obj");
}

TEST_F(ViewerProgram, OpenMeshesAreNoSolids) {
  std::ofstream(folder_ / "open.stl")
      << "solid open\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
         "vertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n";
  expect_refused("open.stl --screenshot x.png", 1, "open.stl");
  expect_refused("a.obj open.stl --no-interface --screenshot x.png", 1, "open.stl");
}

TEST_F(ViewerProgram, PicturesArePngByNameToo) {
  expect_refused("a.obj --screenshot x.jpg", 2, ".png");
  EXPECT_FALSE(fs::exists(folder_ / "x.jpg"));
}

TEST_F(ViewerProgram, StepsThatAreNotThereAreErrors) {
  for (const char* interface : {"", " --no-interface"})
    expect_refused(
        std::string("--sample fig13 --phase joining --step 999 --screenshot x.png") + interface, 2,
        "phase joining has only");
  expect_refused("a.obj --phase joining --screenshot x.png", 2, "there are no steps");
}

}  // namespace
}  // namespace sectile::viewer
