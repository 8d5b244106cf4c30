// PLY files as other programs write them: every type, both byte orders, further elements.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

#include "file_samples.h"

namespace sectile::test {
namespace {

template <class T>
void put(std::string& bytes, T value, bool big) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (big != (std::endian::native == std::endian::big)) std::reverse(raw, raw + sizeof(T));
  bytes.append(raw, sizeof(T));
}

template <class Real, class Count, class Index>
std::string binary_ply(const PolygonMesh& mesh, bool big, const std::string& real,
                       const std::string& count, const std::string& index) {
  std::string bytes = "ply\nformat binary_" + std::string(big ? "big" : "little") +
                      "_endian 1.0\ncomment end_header\nelement vertex " +
                      std::to_string(mesh.positions.size()) + "\nproperty uchar red\nproperty " +
                      real + " x\nproperty " + real + " y\nproperty " + real + " z\nelement face " +
                      std::to_string(mesh.face_sizes.size()) + "\nproperty list " + count + " " +
                      index + " vertex_index\nproperty list uchar short other\nend_header\n";
  for (const Vec3& p : mesh.positions) {
    put(bytes, std::uint8_t{200}, big);
    for (const double c : {p.x, p.y, p.z}) put(bytes, static_cast<Real>(c), big);
  }
  std::size_t at = 0;
  for (const std::uint32_t size : mesh.face_sizes) {
    put(bytes, static_cast<Count>(size), big);
    for (std::uint32_t i = 0; i < size; ++i)
      put(bytes, static_cast<Index>(mesh.indices[at++]), big);
    put(bytes, std::uint8_t{1}, big);
    put(bytes, std::int16_t{-1}, big);
  }
  return bytes;
}

TEST(FilesPly, BinaryDoubles) {
  const PolygonMesh mesh = awkward_triangles();
  for (const bool big : {false, true}) {
    EXPECT_TRUE(same_bits(
        read(binary_ply<double, std::uint8_t, std::int32_t>(mesh, big, "double", "uchar", "int"),
             FileFormat::ply_binary),
        mesh));
    EXPECT_TRUE(same_bits(read(binary_ply<double, std::int32_t, std::uint16_t>(mesh, big, "float64",
                                                                               "int32", "uint16"),
                               FileFormat::ply_text),
                          mesh));
  }
}

TEST(FilesPly, LinesWithoutKeywordBeforeTheElementsAreComments) {
  std::string content = written(tetrahedron(), FileFormat::ply_text);
  const std::size_t at = content.find("element vertex");
  ASSERT_NE(at, std::string::npos);
  content.insert(at, "Created by some program, 1996\n");
  EXPECT_TRUE(same_bits(read(content, FileFormat::ply_text), tetrahedron()));
}

TEST(FilesPly, BinaryFloats) {
  PolygonMesh mesh = prism(300);
  for (Vec3& p : mesh.positions)
    for (double* c : {&p.x, &p.y, &p.z}) {
      const volatile float rounded = static_cast<float>(*c);
      *c = rounded;
    }
  for (const bool big : {false, true})
    EXPECT_TRUE(same_bits(read(binary_ply<float, std::uint16_t, std::int16_t>(mesh, big, "float32",
                                                                              "ushort", "int16"),
                               FileFormat::ply_binary),
                          mesh));
}

TEST(FilesPly, SmallIntegers) {
  for (const bool big : {false, true})
    EXPECT_TRUE(same_bits(read(binary_ply<std::int8_t, std::int8_t, std::uint8_t>(
                                   tetrahedron(), big, "char", "int8", "uint8"),
                               FileFormat::ply_binary),
                          tetrahedron()));
}

TEST(FilesPly, TextWithFurtherElements) {
  const std::string content =
      "ply\r\nformat ascii 1.0\r\nobj_info x\r\nelement material 2\r\nproperty float shine\r\n"
      "element vertex 4\r\nproperty float z\r\nproperty float x\r\nproperty list int int tags\r\n"
      "property float y\r\nelement face 4\r\nproperty list uchar int vertex_indices\r\n"
      "element edge 1\r\nproperty int a\r\nend_header\r\nnan\r\n1\r\n0 0 0 0\r\n0 1 2 8 9 0\r\n"
      "\r\n0 0 0 1\r\n1 0 0 0\r\n3 0 2 1\r\n3 0 1 3\r\n3 0 3 2\r\n3 1 2 3\r\n7";
  EXPECT_TRUE(same_bits(read(content, FileFormat::ply_text), tetrahedron()));
}

TEST(FilesPly, BinaryRefusalsNameTheByte) {
  const std::string good = binary_ply<float, std::uint8_t, std::uint32_t>(tetrahedron(), false,
                                                                          "float", "uchar", "uint");
  EXPECT_EQ(refusal(good, FileFormat::ply_binary), "");
  EXPECT_EQ(refusal(good + "x", FileFormat::ply_binary),
            "file: byte " + std::to_string(good.size()) + ": 1 bytes follow after the last item");
  PolygonMesh bad = tetrahedron();
  bad.indices[4] = 4;
  const std::string said =
      refusal(binary_ply<float, std::uint8_t, std::uint32_t>(bad, true, "float", "uchar", "uint"),
              FileFormat::ply_binary);
  EXPECT_TRUE(said.starts_with("file: byte ") && said.find("vertex 4 does not exist") != said.npos)
      << said;
  bad = tetrahedron();
  bad.positions[2].y = std::nan("");
  EXPECT_NE(
      refusal(binary_ply<double, std::uint8_t, std::uint32_t>(bad, true, "double", "uchar", "uint"),
              FileFormat::ply_binary)
          .find("not finite"),
      std::string::npos);
  bad = tetrahedron();
  bad.indices[0] = static_cast<std::uint32_t>(-1);
  EXPECT_NE(
      refusal(binary_ply<double, std::uint8_t, std::int32_t>(bad, true, "double", "uchar", "int"),
              FileFormat::ply_binary)
          .find("vertex -1 does not exist"),
      std::string::npos);
}

}  // namespace
}  // namespace sectile::test
