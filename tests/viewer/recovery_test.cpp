#include "scene/recovery.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace sectile::viewer {
namespace {

namespace fs = std::filesystem;

class RecoveryTest : public testing::Test {
 protected:
  void SetUp() override {
    data_ = fs::path(testing::TempDir()) / ("recovery_test_" + std::to_string(getpid()));
    fs::remove_all(data_);
  }
  void TearDown() override { fs::remove_all(data_); }

  static Scene scene(double x) {
    Scene made;
    auto mesh = std::make_shared<PolygonMesh>();
    mesh->positions = {{x, 0.1, 0.2}, {1, 0, 0}, {0, 1, 0}};
    mesh->face_sizes = {3};
    mesh->indices = {0, 1, 2};
    Node node;
    node.what = Imported{"a.obj", mesh};
    made.add(node);
    return made;
  }

  /// A process that keeps these scenes and then ends without any goodbye.
  void crash_after(const std::vector<Scene>& scenes) {
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      Recovery recovery(data_);
      for (const Scene& kept : scenes) {
        recovery.keep({kept, R"({"dark":true})"}, "Bracket");
        recovery.flush();
      }
      _exit(recovery.error().empty() ? 0 : 1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  }

  fs::path data_;
};

TEST_F(RecoveryTest, WorkOutlivesACrash) {
  crash_after({scene(1), scene(2)});
  const std::vector<LostWork> lost = Recovery::find(data_);
  ASSERT_EQ(lost.size(), 1u);
  EXPECT_EQ(lost[0].title, "Bracket");
  const SceneDocument back = Recovery::read(lost[0]);
  EXPECT_TRUE(back.scene == scene(2));
  EXPECT_EQ(back.view, R"({"dark":true})");
  Recovery::discard(lost[0]);
  EXPECT_TRUE(Recovery::find(data_).empty());
}

TEST_F(RecoveryTest, ACrashWithNothingUnsavedLeavesNothing) {
  crash_after({});
  EXPECT_TRUE(Recovery::find(data_).empty());
  EXPECT_TRUE(fs::is_empty(data_ / "recovery"));
}

TEST_F(RecoveryTest, RunningAndCleanlyEndedSessionsAreNoCrashes) {
  {
    Recovery recovery(data_);
    recovery.keep({scene(1), ""}, "x");
    recovery.flush();
    EXPECT_EQ(recovery.error(), "");
    EXPECT_TRUE(Recovery::find(data_).empty());
  }
  EXPECT_TRUE(Recovery::find(data_).empty());
  EXPECT_TRUE(fs::is_empty(data_ / "recovery"));
}

TEST_F(RecoveryTest, OnlyTheMeshesInUseAreKept) {
  Recovery recovery(data_);
  for (int i = 0; i < 5; ++i) {
    recovery.keep({scene(i), ""}, "x");
    recovery.flush();
  }
  std::size_t meshes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(data_))
    meshes += entry.path().filename().string().starts_with("mesh-");
  EXPECT_EQ(meshes, 1u);
  recovery.forget();
  recovery.flush();
  EXPECT_EQ(recovery.error(), "");
}

TEST_F(RecoveryTest, SaysWhenNothingCanBeKept) {
  fs::create_directories(data_.parent_path());
  write_whole(data_, "a file, not a folder");
  EXPECT_THROW(Recovery{data_}, FileError);
}

}  // namespace
}  // namespace sectile::viewer
