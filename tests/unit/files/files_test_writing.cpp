// Files in their places: whole or not at all.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "file_samples.h"

namespace sectile::test {
namespace {

namespace fs = std::filesystem;

class FilesWriting : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "sectile-files-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::size_t file_count() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  static std::string why_not_written(const fs::path& path, const PolygonMesh& mesh) {
    try {
      write_mesh(path, mesh);
    } catch (const FileError& error) {
      return error.what();
    }
    return {};
  }

  static std::string content(const fs::path& path) {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  fs::path folder_;
};

TEST_F(FilesWriting, EveryExtensionReadsBack) {
  for (const char* name : {"a.obj", "a.off", "a.ply", "a.OBJ", "a.Ply"}) {
    write_mesh(folder_ / name, tetrahedron());
    EXPECT_TRUE(same_bits(read_mesh(folder_ / name), tetrahedron())) << name;
  }
  write_mesh(folder_ / "a.stl", tetrahedron());
  EXPECT_TRUE(same_bits(read_mesh(folder_ / "a.stl"), unshared(tetrahedron())));
  write_mesh(folder_ / "a.3mf", tetrahedron());
  EXPECT_TRUE(same_bits(read_mesh(folder_ / "a.3mf"), tetrahedron()));
  EXPECT_EQ(file_count(), 7u);
}

TEST_F(FilesWriting, MeshesThatNoReaderTakesAreRefused) {
  const auto expect_refused = [&](const PolygonMesh& mesh, const char* name, const char* why) {
    const std::string said = why_not_written(folder_ / name, mesh);
    EXPECT_NE(said.find(why), std::string::npos) << why << " but: " << said;
    EXPECT_EQ(file_count(), 0u);
  };
  PolygonMesh mesh = tetrahedron();
  mesh.positions[1].y = std::nan("");
  expect_refused(mesh, "a.obj", "position 1 is not finite");
  mesh = tetrahedron();
  mesh.indices[3] = 4;
  expect_refused(mesh, "a.ply", "there is no position 4; there are 4");
  mesh = tetrahedron();
  mesh.face_sizes[0] = 4;
  expect_refused(mesh, "a.off", "13 corners, but there are 12 indices");
  mesh.face_sizes = {2, 4, 3, 3};
  expect_refused(mesh, "a.off", "face 0 has fewer than three corners");
  expect_refused(prism(5), "a.stl", "face 0 has 5 corners");
  mesh = tetrahedron();
  mesh.positions[1].x = 3.5e38;
  expect_refused(mesh, "a.stl", "no coordinates beyond 3.4e+38");
  expect_refused(tetrahedron(), "a.dwg", "unknown extension \".dwg\"");
}

TEST_F(FilesWriting, FailuresLeaveTheOldFile) {
  const fs::path path = folder_ / "a.obj";
  write_mesh(path, tetrahedron());
  PolygonMesh bad = tetrahedron();
  bad.positions[0].x = std::nan("");
  EXPECT_NE(why_not_written(path, bad), "");
  EXPECT_TRUE(same_bits(read_mesh(path), tetrahedron()));
  EXPECT_EQ(file_count(), 1u);
}

TEST_F(FilesWriting, PlacesThatCannotBeWritten) {
  fs::create_directory(folder_ / "b.obj");
  EXPECT_NE(why_not_written(folder_ / "b.obj", tetrahedron()).find("Is a directory"),
            std::string::npos);
  EXPECT_NE(why_not_written(folder_ / "none" / "a.obj", tetrahedron()).find("No such file"),
            std::string::npos);
  EXPECT_THROW(write_whole("/dev/full", "text"), FileError);
  EXPECT_EQ(file_count(), 1u);
}

TEST_F(FilesWriting, PermissionsAndLinksStay) {
  const fs::path path = folder_ / "a.obj", link = folder_ / "link.obj";
  std::ofstream(path) << "old";
  fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("a.obj", link);
  write_mesh(link, tetrahedron());
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_TRUE(same_bits(read_mesh(path), tetrahedron()));
  EXPECT_EQ(fs::status(path).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(FilesWriting, SeveralFilesAppearTogether) {
  write_whole(folder_ / "a", "old");
  {
    WholeFiles files;
    files.add(folder_ / "a", "new");
    files.add(folder_ / "b", "other");
    EXPECT_EQ(content(folder_ / "a"), "old");
    EXPECT_FALSE(fs::exists(folder_ / "b"));
    files.place();
  }
  EXPECT_EQ(content(folder_ / "a"), "new");
  EXPECT_EQ(content(folder_ / "b"), "other");
  EXPECT_EQ(file_count(), 2u);
}

// The last place becomes a folder only after its content was written.
TEST_F(FilesWriting, SeveralFilesAreTakenBackTogether) {
  write_whole(folder_ / "a", "old");
  {
    WholeFiles files;
    for (const char* name : {"a", "b", "c"}) files.add(folder_ / name, "new");
    fs::create_directory(folder_ / "c");
    EXPECT_THROW(files.place(), FileError);
  }
  EXPECT_EQ(content(folder_ / "a"), "old");
  EXPECT_FALSE(fs::exists(folder_ / "b"));
  EXPECT_EQ(file_count(), 2u);
}

TEST_F(FilesWriting, FilesThatAreNotPlacedLeaveNothing) {
  { WholeFiles().add(folder_ / "a", "new"); }
  EXPECT_EQ(file_count(), 0u);
}

TEST_F(FilesWriting, FilesThatCannotBeRead) {
  for (const auto& [name, why] :
       {std::pair{"none.obj", "No such file"}, {"folder.obj", "directory"}}) {
    fs::create_directory(folder_ / "folder.obj");
    try {
      read_mesh(folder_ / name);
      ADD_FAILURE() << name << " was read";
    } catch (const FileError& error) {
      EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
    }
  }
}

TEST_F(FilesWriting, StreamsThatFail) {
  std::ostringstream out;
  out.setstate(std::ios::badbit);
  EXPECT_THROW(write_mesh(out, FileFormat::off, tetrahedron(), "stream"), FileError);
  std::ofstream full("/dev/full");
  EXPECT_THROW(write_mesh(full, FileFormat::off, tetrahedron(), "stream"), FileError);
}

}  // namespace
}  // namespace sectile::test
