// Files that are not what their format says: refused, with the line and the reason.
#include <gtest/gtest.h>

#include "file_samples.h"

namespace sectile::test {
namespace {

struct Case {
  std::string content, message;
};

void expect_refused(FileFormat format, const std::vector<Case>& cases) {
  for (const Case& one : cases) {
    const std::string said = refusal(one.content, format);
    EXPECT_TRUE(said.starts_with(one.message)) << one.content << "gave: " << said;
  }
}

const std::string off_points = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";

TEST(FilesMalformed, Off) {
  expect_refused(
      FileFormat::off,
      {{"", "file:1: the file is empty"},
       {"OBJ\n", "file:1: \"OFF\" is expected, not \"OBJ\""},
       {"OFF BINARY\n", "file:1: the number of vertices \"BINARY\" is not an integer"},
       {"OFF\n3 1\n", "file:3: the file ends where the number of edges is expected"},
       {"OFF\n-3 1 0\n", "file:2: the number of vertices does not fit"},
       {"OFF\n4000000000 1 0\n0 0 0\n", "file:2: the number of vertices does not fit"},
       {"OFF\n3 99999999999999999999 0\n", "file:2: the number of faces"},
       {"OFF\n3 1 0\n0 0 0\n1 0 0 5\n", "file:4: a vertex with more than three coordinates"},
       {"COFF\n3 1 0\n0 0 0\n1 0 0 red\n", "file:4: the colour or normal \"red\" is not a number"},
       {"OFF\n3 1 0\n0 0 0\n1 0 inf\n", "file:4: the coordinate \"inf\" is not finite"},
       {off_points + "2 0 1\n", "file:6: a face with 2 corners"},
       {off_points + "-1\n", "file:6: a face with -1 corners"},
       {off_points + "4000000000 0 1\n", "file:6: a face with 4000000000 corners"},
       {off_points + "3 0 1 3\n", "file:6: vertex 3 does not exist; there are 3, counted from 0"},
       {off_points + "3 0 1 -1\n", "file:6: vertex -1 does not exist"},
       {off_points + "3 0 1\n", "file:7: the file ends where a vertex number is expected"},
       {off_points + "3 0 1 2 255 0 0 1 1\n", "file:6: more than four numbers after a face"},
       {off_points + "3 0 1 2\n3 2 1 0\n", "file:7: \"3\" follows after the last face"}});
}

std::string ply(const std::string& vertex, const std::string& rest) {
  return "ply\nformat ascii 1.0\nelement vertex 3\n" + vertex + rest;
}
const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string faces = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
const std::string ply_points = ply(xyz, faces) + "0 0 0\n1 0 0\n0 1 0\n";

TEST(FilesMalformed, PlyHeader) {
  expect_refused(
      FileFormat::ply_text,
      {{"", "file:1: the file is empty"},
       {"plx\n", "file:1: \"ply\" is expected"},
       {"ply\n", "file:2: the file ends within its header"},
       {"ply\nformat ascii 2.0\n", "file:2: version 1.0 is expected"},
       {"ply\nformat ebcdic 1.0\n", "file:2: unknown format \"ebcdic\""},
       {"ply\nelement vertex 0\nend_header\n", "file:3: the header has no \"format\""},
       {"ply\nformat ascii 1.0\nformat ascii 1.0\n", "file:3: a second \"format\""},
       {"ply\nformat ascii 1.0\nproperty float x\n", "file:3: a property before the first"},
       {"ply\nformat ascii 1.0\nelement vertex -1\n", "file:3: the number of elements does not"},
       {"ply\nformat ascii 1.0\nelement vertex many\n", "file:3: the number of elements \"many\""},
       {"ply\nformat ascii 1.0\nelement vertex 3000000000\n" + xyz + faces,
        "file:3: the number of elements does not fit"},
       {ply(xyz, "hello\n"), "file:7: unknown word \"hello\" in the header"},
       {"ply\nformat ascii 1.0\nhello\n", "file:4: the file ends within its header"},
       {ply("property float x\nproperty float y\n", faces),
        "file:8: vertices have no property \"z\""},
       {ply("property real x\n", ""), "file:4: unknown type \"real\""},
       {ply("property float\n", ""), "file:4: a property without a name"},
       {ply("property float x\nproperty int x\n", ""), "file:5: a second property \"x\""},
       {ply("property list float int x\n", ""), "file:4: the length of a list must be an integer"},
       {ply(xyz, "end_header x\n"), "file:7: \"x\" is too much"},
       {ply(xyz, "element face 1\nproperty list uchar float vertex_indices\n"),
        "file:8: vertex numbers must be integers"},
       {ply(xyz, "element face 1\nproperty uchar red\nend_header\n"),
        "file:9: faces have no list \"vertex_indices\""},
       {ply(xyz, "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"),
        "file:9: triangle strips are not read"},
       {ply(xyz, "element vertex 3\n" + xyz + "end_header\n"), "file:11: a second element"},
       {"ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\n"
        "element vertex 3\n" +
            xyz + "end_header\n0 0 0 0\n",
        "file:9: faces stand before vertices"},
       {ply("", "end_header\n"), "file:4: element \"vertex\" has no properties"}});
}

TEST(FilesMalformed, PlyText) {
  expect_refused(
      FileFormat::ply_text,
      {{ply(xyz, faces) + "0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "file:10: the coordinate is missing"},
       {ply(xyz, faces) + "0 0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "file:10: \"0\" is more than"},
       {ply(xyz, faces) + "0 0 x\n", "file:10: the coordinate \"x\" is not a number"},
       {ply(xyz, faces) + "0 0 1e999\n", "file:10: the coordinate \"1e999\" is outside"},
       {ply(xyz, faces) + "0 0 0\n", "file:11: the file ends where another item is expected"},
       {ply_points + "2 0 1\n", "file:13: a face with 2 corners"},
       {ply_points + "-3 0 1 2\n", "file:13: a list of -3 values does not fit"},
       {ply_points + "4000000000 0 1 2\n", "file:13: a list of 4000000000 values does not fit"},
       {ply_points + "3 0 1 3\n", "file:13: vertex 3 does not exist; there are 3"},
       {ply_points + "3 0 1 1.5\n", "file:13: the length or vertex number \"1.5\" is not an"},
       {ply_points + "3 0 1\n", "file:13: the length or vertex number is missing"},
       {ply_points + "3 0 1 2\nmore\n", "file:14: \"more\" follows after the last item"}});
}

std::string facet(const std::string& corners) {
  return "solid\nfacet normal 0 0 1\nouter loop\n" + corners;
}

TEST(FilesMalformed, StlText) {
  expect_refused(
      FileFormat::stl_text,
      {{"", "file:1: the file is empty"},
       {"solid", "file:1: the file ends without \"endsolid\""},
       {"solid a\nsolid b\n", "file:2: \"facet\" or \"endsolid\" is expected, not \"solid\""},
       {"solid\nfacet normal 0 0 1\nvertex 0 0 0\n", "file:3: \"outer\" is expected"},
       {facet("vertex 0 0 zero\n"), "file:4: the coordinate \"zero\" is not a number"},
       {facet("vertex 0 0 nan\n"), "file:4: the coordinate \"nan\" is not finite"},
       {facet("vertex 0 0 0\nvertex 1 0 0\nendloop\n"), "file:6: \"vertex\" is expected"},
       {facet("vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nvertex 1 1 0\n"),
        "file:7: \"endloop\" is expected, not \"vertex\""},
       {facet("vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"),
        "file:9: the file ends where"},
       {"solid\nendsolid\njunk\n", "file:3: \"solid\" is expected, not \"junk\""},
       {"not an stl file\n", "file:1: \"solid\" is expected, not \"not\""}});
}

TEST(FilesMalformed, StlTextIsReadInAnyCaseAndInParts) {
  const std::string one =
      " SOLID a b\r\n  FACET NORMAL nan nan nan\r\n OUTER LOOP\r\n VERTEX 0 0 0\r\n vertex 1 0 "
      "0\r\n"
      " vertex 0 1 0\r\n ENDLOOP\r\n ENDFACET\r\nENDSOLID a b\r\n";
  EXPECT_EQ(read(one, FileFormat::stl_text).face_sizes.size(), 1u);
  EXPECT_EQ(read(one + one, FileFormat::stl_text).face_sizes.size(), 2u);
}

TEST(FilesMalformed, StlBinary) {
  std::string good = written(tetrahedron(), FileFormat::stl_binary);
  EXPECT_EQ(refusal(good, FileFormat::stl_binary), "");
  EXPECT_EQ(refusal(good + " ", FileFormat::stl_binary),
            "file: byte 285: 4 triangles need 284 bytes, but the file has 285");
  std::string nan = good;
  nan.replace(84 + 12 + 4, 4, "\x00\x00\xc0\x7f", 4);
  EXPECT_EQ(refusal(nan, FileFormat::stl_binary),
            "file: byte 96: triangle 0 has a coordinate that is not finite");
  std::string many = good;
  many.replace(80, 4, "\xff\xff\xff\xff", 4);
  EXPECT_EQ(refusal(many, FileFormat::stl_binary),
            "file: byte 284: 4294967295 triangles need 214748364834 bytes, but the file has 284");
  // A comment that looks like the text form does not mislead.
  good.replace(0, 6, "solid ");
  EXPECT_EQ(read(good, FileFormat::stl_text).face_sizes.size(), 4u);
}

}  // namespace
}  // namespace sectile::test
