// The copy against crashes: what is in it after which edits.
#include "app/document.h"

#include <gtest/gtest.h>
#include <unistd.h>

namespace sectile::viewer {
namespace {

namespace fs = std::filesystem;

class DocumentCopy : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("sectile_document_" + std::to_string(getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  static Scene blocks(int count) {
    Scene scene;
    for (int i = 0; i < count; ++i) scene.add(Node());
    return scene;
  }

  /// What a crash now would leave behind.
  std::optional<Scene> copy() const {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_ / "recovery"))
      if (fs::exists(entry.path() / "scene.json"))
        return Recovery::read({entry.path(), {}, {}}).scene;
    return std::nullopt;
  }

  fs::path folder_;
};

TEST_F(DocumentCopy, UndoToWhatIsSavedLeavesNone) {
  Document document(folder_);
  document.commit("one", blocks(1));
  document.save(folder_ / "a.sectile");
  document.commit("two", blocks(2));
  ASSERT_TRUE(document.keep_copy_now());
  EXPECT_EQ(copy(), blocks(2));
  document.undo();
  ASSERT_TRUE(document.keep_copy_now());
  EXPECT_EQ(copy(), std::nullopt) << "it would bring back what was undone";
  document.redo();
  ASSERT_TRUE(document.keep_copy_now());
  EXPECT_EQ(copy(), blocks(2));
}

TEST_F(DocumentCopy, ADragDoesNotHoldBackWhatWasDoneBefore) {
  Document document(folder_);
  document.commit("one", blocks(1));
  document.show_draft("drag", blocks(3));
  ASSERT_TRUE(document.keep_copy_now());
  EXPECT_EQ(copy(), blocks(1));
  document.commit_draft();
  ASSERT_TRUE(document.keep_copy_now());
  EXPECT_EQ(copy(), blocks(3));
}

}  // namespace
}  // namespace sectile::viewer
