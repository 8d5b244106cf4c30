// Files cut off after every byte: refused, or nothing that counts is missing.
#include <gtest/gtest.h>

#include <regex>

#include "file_samples.h"

namespace sectile::test {
namespace {

class FilesTruncated : public ::testing::TestWithParam<FileFormat> {};

TEST_P(FilesTruncated, AfterEveryByte) {
  const PolygonMesh mesh = tetrahedron();
  const std::string whole = written(mesh, GetParam());
  const PolygonMesh read_whole = read(whole, GetParam());
  const std::regex position("^file:( byte)? ?[0-9]+: .+|^file: package: .+");
  std::size_t refused = 0;
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const std::string said = refusal(whole.substr(0, size), GetParam());
    if (said.empty()) {
      EXPECT_TRUE(same_bits(read(whole.substr(0, size), GetParam()), read_whole)) << size;
    } else {
      EXPECT_TRUE(std::regex_match(said, position)) << size << ": " << said;
      ++refused;
    }
  }
  // Only the last line's end and the name after "endsolid" may be missing.
  EXPECT_GE(refused, whole.size() - std::string(" sectile\n").size());
}
std::string format_name(const ::testing::TestParamInfo<FileFormat>& test) {
  switch (test.param) {
    case FileFormat::off:
      return "off";
    case FileFormat::ply_text:
      return "ply_text";
    case FileFormat::ply_binary:
      return "ply_binary";
    case FileFormat::stl_text:
      return "stl_text";
    case FileFormat::stl_binary:
      return "stl_binary";
    case FileFormat::three_mf:
      return "three_mf";
    case FileFormat::obj:
      break;
  }
  return "obj";
}

INSTANTIATE_TEST_SUITE_P(Formats, FilesTruncated,
                         ::testing::Values(FileFormat::off, FileFormat::ply_text,
                                           FileFormat::ply_binary, FileFormat::stl_text,
                                           FileFormat::stl_binary, FileFormat::three_mf),
                         format_name);

// OBJ does not say how much there should be: what is complete is kept.
TEST(FilesTruncatedObj, AfterEveryByte) {
  const std::string whole = written(tetrahedron(), FileFormat::obj);
  const PolygonMesh mesh = tetrahedron();
  for (std::size_t size = 1; size < whole.size(); ++size) {
    const std::string content = whole.substr(0, size);
    const std::string said = refusal(content, FileFormat::obj);
    if (!said.empty()) {
      const auto line = 1 + std::count(content.begin(), content.end(), '\n');
      EXPECT_TRUE(said.starts_with("file:" + std::to_string(line) + ": ")) << said;
      continue;
    }
    const PolygonMesh part = read(content, FileFormat::obj);
    ASSERT_LE(part.positions.size(), mesh.positions.size());
    ASSERT_LE(part.indices.size(), mesh.indices.size());
    EXPECT_TRUE(std::equal(part.positions.begin(), part.positions.end(), mesh.positions.begin()));
    EXPECT_TRUE(std::equal(part.indices.begin(), part.indices.end(), mesh.indices.begin()));
  }
}

}  // namespace
}  // namespace sectile::test
