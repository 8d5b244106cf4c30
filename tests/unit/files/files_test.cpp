// What is written reads back as the same, to the bit.
#include <gtest/gtest.h>

#include "file_samples.h"

namespace sectile::test {
namespace {

constexpr FileFormat polygon_formats[] = {FileFormat::obj, FileFormat::off, FileFormat::ply_text,
                                          FileFormat::ply_binary};

TEST(FilesRoundTrip, EveryBitOfEveryCoordinate) {
  const PolygonMesh mesh = awkward_triangles();
  for (const FileFormat format : polygon_formats)
    EXPECT_TRUE(same_bits(read(written(mesh, format), format), mesh)) << static_cast<int>(format);
  EXPECT_TRUE(
      same_bits(read(written(mesh, FileFormat::stl_text), FileFormat::stl_text), unshared(mesh)));
}

TEST(FilesRoundTrip, PolygonsOfAnySize) {
  for (const std::uint32_t corners : {3u, 4u, 255u, 256u, 300u, 70000u})
    for (const FileFormat format : polygon_formats)
      EXPECT_TRUE(same_bits(read(written(prism(corners), format), format), prism(corners)))
          << corners << " corners in format " << static_cast<int>(format);
}

TEST(FilesRoundTrip, TheEmptyMesh) {
  for (const FileFormat format :
       {FileFormat::obj, FileFormat::off, FileFormat::ply_text, FileFormat::ply_binary,
        FileFormat::stl_text, FileFormat::stl_binary}) {
    const std::string content = written({}, format);
    EXPECT_FALSE(content.empty());
    EXPECT_TRUE(same_bits(read(content, format), {})) << static_cast<int>(format);
  }
}

TEST(FilesRoundTrip, BinaryStlRoundsToFloatsOnce) {
  PolygonMesh mesh = awkward_triangles();
  for (Vec3& p : mesh.positions)
    for (double* c : {&p.x, &p.y, &p.z})
      if (std::abs(*c) > 3e38) *c = 1e-50;
  const PolygonMesh once = read(written(mesh, FileFormat::stl_binary), FileFormat::stl_binary);
  const PolygonMesh apart = unshared(mesh);
  ASSERT_EQ(once.positions.size(), apart.positions.size());
  for (std::size_t i = 0; i < once.positions.size(); ++i) {
    const volatile float x = static_cast<float>(apart.positions[i].x);
    EXPECT_EQ(once.positions[i].x, x);
  }
  EXPECT_TRUE(same_bits(read(written(once, FileFormat::stl_binary), FileFormat::stl_binary), once));
}

TEST(FilesRoundTrip, TheShortestDigitsAreWritten) {
  const std::string content =
      written({{{0.1, 100, -0.0}, {1e23, 5e-324, 0.30000000000000004}, {1, 2, 3}}, {3}, {0, 1, 2}},
              FileFormat::obj);
  EXPECT_EQ(content, "v 0.1 100 -0\nv 1e+23 5e-324 0.30000000000000004\nv 1 2 3\nf 1 2 3\n");
}

// Halfway cases, and digits beyond the seventeenth that decide.
TEST(FilesReading, CoordinatesAreRoundedCorrectly) {
  const std::pair<const char*, double> cases[] = {
      {"9007199254740993", 9007199254740992.0},
      {"9007199254740993.0000000000000000000000000001", 9007199254740994.0},
      {"1.00000000000000011102230246251565404236316680908203125", 1.0},
      {"1.00000000000000011102230246251565404236316680908203126", 1.0000000000000002},
      {"2.2250738585072011e-308", 2.2250738585072011e-308},
      {"2.4703282292062327e-324", 0.0},
      {"2.4703282292062328e-324", 5e-324},
      {"1e-400", 0.0},
      {"-1e-400", -0.0},
      {"+1.5", 1.5},
      {".5", 0.5},
      {"5.", 5.0},
      {"1E3", 1000.0},
      {"179769313486231580793e288", 1.7976931348623157e308}};
  for (const auto& [text, value] : cases) {
    const PolygonMesh mesh =
        read("v " + std::string(text) + " 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", FileFormat::obj);
    EXPECT_EQ(std::memcmp(&mesh.positions[0].x, &value, sizeof value), 0)
        << text << " became " << mesh.positions[0].x;
  }
}

}  // namespace
}  // namespace sectile::test
