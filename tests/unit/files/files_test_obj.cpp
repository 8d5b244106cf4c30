// What OBJ files may look like.
#include <gtest/gtest.h>

#include "file_samples.h"

namespace sectile::test {
namespace {

const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

PolygonMesh obj(const std::string& content) {
  return read(content, FileFormat::obj);
}

TEST(FilesObj, FormsOfCorners) {
  const PolygonMesh mesh = obj(
      points + "vt 0 0\nvn 0 0 1\nf 1 3 2\nf 1/1 2/1 4/1\nf 1//1 4//1 3//1\nf 2/1/1 3/1/1 4/1/1\n");
  EXPECT_TRUE(same_bits(mesh, tetrahedron()));
}

TEST(FilesObj, NumbersAreCountedFromTheLastVertex) {
  const PolygonMesh mesh =
      obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -1 -2\nv 0 0 1\nf -4 -3 -1\nf 1 4 3\nf 2 3 -1\n");
  EXPECT_TRUE(same_bits(mesh, tetrahedron()));
}

TEST(FilesObj, LinesEndInAnyWay) {
  const std::string unix_lines = written(tetrahedron(), FileFormat::obj);
  for (const char* end : {"\r\n", "\r", "\n\n", "  \t\n", " # comment\n", "#comment\r\n"}) {
    std::string content;
    for (const char c : unix_lines) c == '\n' ? content += end : content += c;
    EXPECT_TRUE(same_bits(obj(content), tetrahedron())) << end;
    content.resize(content.size() - std::string(end).size());
    EXPECT_TRUE(same_bits(obj(content), tetrahedron())) << "without the last " << end;
  }
}

TEST(FilesObj, BackslashesJoinLines) {
  EXPECT_TRUE(
      same_bits(obj("v 0 0 \\\n0\nv 1\\\r\n 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf \\\n1 2\\\n 4\n"
                    "f 1 4 3\ng a \\\n b\nf 2 3 4 \\\n\n"),
                tetrahedron()));
  // Not those in comments: the vertex after this one would be lost.
  EXPECT_EQ(obj("# C:\\parts\\\n" + points).positions.size(), 4u);
  const std::string message = refusal(points + "f 1 \\\n 2 \\\n x\n", FileFormat::obj);
  EXPECT_TRUE(message.starts_with("file:7: ")) << message;
}

TEST(FilesObj, NamesMaterialsAndColoursArePassedOver) {
  EXPECT_TRUE(same_bits(
      obj("mtllib none.mtl\no part\ng a b\ns off\nusemtl red\nv 0 0 0 1\nv 1 0 0 0.5 0.25 1\n"
          "v 0 1 0 1 .1 .2 .3\nv 0 0 1\nf 1 3 2\ng\nf 1 2 4\ns 1\nf 1 4 3\nf 2 3 4\n"),
      tetrahedron()));
}

TEST(FilesObj, Refusals) {
  const std::pair<const char*, const char*> cases[] = {
      {"f 1 2 5\n", "file:5: vertex 5 does not exist; there are 4 so far"},
      {"f 1 2 -5\n", "file:5: vertex -5 does not exist"},
      {"f 0 1 2\n", "file:5: vertex 0 does not exist"},
      {"\n\nf 1 2 99999\nv 0 0 0\n", "file:7: vertex 99999"},
      {"f 1 2 99999999999999999999\n", "file:5: \"99999999999999999999\" holds a number that is"},
      {"f 1 2 4294967297\n", "file:5: \"4294967297\" holds a number that is too large"},
      {"f 1 2\n", "file:5: a face needs at least three corners"},
      {"f\n", "file:5: a face needs at least three corners"},
      {"f 1 2 x\n", "file:5: \"x\" is not a corner"},
      {"f 1 2 3.5\n", "file:5: \"3.5\" is not a corner"},
      {"f 1 2 3/1/1/1\n", "file:5: \"3/1/1/1\" is not a corner"},
      {"f 1 2 /3\n", "file:5: \"/3\" is not a corner"},
      {"f 1 2 3/-\n", "file:5: \"3/-\" is not a corner"},
      {"f 1 2 --3\n", "file:5: \"--3\" is not a corner"},
      {"f 1 2 nan\n", "file:5: \"nan\" is not a corner"},
      {"v 0 0\n", "file:5: the coordinate is missing"},
      {"v 0 0 nan\n", "file:5: the coordinate \"nan\" is not finite"},
      {"v 0 -inf 0\n", "file:5: the coordinate \"-inf\" is not finite"},
      {"v 1e400 0 0\n", "file:5: the coordinate \"1e400\" is outside the range of doubles"},
      {"v 0 0 1,5\n", "file:5: the coordinate \"1,5\" is not a number"},
      {"v 0 0 0x10\n", "file:5: the coordinate \"0x10\" is not a number"},
      {"v 0 0 +-1\n", "file:5: the coordinate \"+-1\" is not a number"},
      {"v 0 0 1e\n", "file:5: the coordinate \"1e\" is not a number"},
      {"v 0 0 0 2\n", "file:5: the weight of the vertex is not 1"},
      {"v 0 0 0 1 2\n", "file:5: a vertex with five numbers"},
      {"v 0 0 0 1 2 3 4 5\n", "file:5: a vertex with more than seven numbers"},
      {"v 0 0 0 red\n", "file:5: the weight or colour \"red\" is not a number"},
      {"l 1 2\n", "file:5: \"l\" elements do not bound solids"},
      {"p 1\n", "file:5: \"p\" elements"},
      {"curv2 1 2\n", "file:5: \"curv2\" elements"},
      {"face 1 2 3\n", "file:5: unknown statement \"face\""},
      {"F 1 2 3\n", "file:5: unknown statement \"F\""},
      {"\x01\x02\n", "file:5: unknown statement \"??\""}};
  for (const auto& [line, message] : cases) {
    const std::string said = refusal(points + line, FileFormat::obj);
    EXPECT_TRUE(said.starts_with(message)) << line << " gave: " << said;
  }
}

}  // namespace
}  // namespace sectile::test
