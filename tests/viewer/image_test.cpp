// PNG files, and the comparison of pictures.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>

#include "drawn_pictures.h"
#include "render/embedded.h"
#include "render/image_difference.h"

namespace sectile::viewer {
namespace {

TEST(Embedded, HoldsFontsAndShaders) {
  EXPECT_EQ(embedded_file("surface.vert").substr(0, 8), "#version");
  EXPECT_GT(embedded_file("Inter-Regular.otf").size(), 100000u);
  EXPECT_THROW(embedded_file("missing"), std::out_of_range);
}

class PngTest : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  const std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) /
      (std::string("png-") + testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(PngTest, ComesBackAsItWas) {
  Image image{3, 2, {}};
  for (int i = 0; i < 24; ++i) image.rgba.push_back(static_cast<std::uint8_t>(i * 10));
  const std::string path = (folder_ / "a.png").string();
  write_png(path, image);
  const Image read = read_png(path);
  EXPECT_EQ(read.width, 3);
  EXPECT_EQ(read.height, 2);
  EXPECT_EQ(read.rgba, image.rgba);
}

TEST_F(PngTest, ReportsWhatCannotBeDone) {
  const Image image{1, 1, {1, 2, 3, 255}};
  EXPECT_THROW(write_png((folder_ / "no" / "a.png").string(), image), std::runtime_error);
  EXPECT_THROW(write_png((folder_ / "b.png").string(), Image{2, 2, {0}}), std::runtime_error);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "b.png"));
  EXPECT_THROW(read_png((folder_ / "b.png").string()), std::runtime_error);
  std::ofstream(folder_ / "c.png") << "no picture";
  EXPECT_THROW(read_png((folder_ / "c.png").string()), std::runtime_error);
}

TEST(ImageDifference, ToleratesNoiseButNotShapes) {
  Image grey{64, 64, std::vector<std::uint8_t>(64 * 64 * 4, 128)};
  EXPECT_EQ(compare_images(grey, grey).mean, 0);
  Image noisy = grey;
  std::mt19937 random(5);
  for (std::uint8_t& value : noisy.rgba)
    value = static_cast<std::uint8_t>(value + static_cast<int>(random() % 9) - 4);
  EXPECT_EQ(compare_images(grey, noisy).share, 0);
  Image square = grey;
  for (std::size_t y = 10; y < 20; ++y)
    for (std::size_t x = 30; x < 40; ++x) square.rgba[(y * 64 + x) * 4] = 255;
  const ImageDifference difference = compare_images(grey, square);
  EXPECT_NEAR(difference.share, 100.0 / (64 * 64), 60.0 / (64 * 64));
  EXPECT_GT(at(difference.picture, 35, 15).r, at(difference.picture, 35, 15).g + 50);
  EXPECT_EQ(at(difference.picture, 5, 50).r, at(difference.picture, 5, 50).g);
  EXPECT_EQ(compare_images(grey, Image{1, 1, {0, 0, 0, 255}}).share, 1);
}

}  // namespace
}  // namespace sectile::viewer
