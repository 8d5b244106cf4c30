// Animated GIFs, read back by another decoder.
#include "render/gif.h"

#include <gtest/gtest.h>
#include <stb_image.h>

#include <memory>
#include <random>
#include <stdexcept>

namespace sectile::viewer {
namespace {

struct Decoded {
  std::vector<Image> frames;
  std::vector<int> milliseconds;
};

Decoded decoded(const std::string& bytes) {
  int* delays = nullptr;
  int width = 0, height = 0, count = 0, channels = 0;
  stbi_uc* pixels = stbi_load_gif_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()),
                                              static_cast<int>(bytes.size()), &delays, &width,
                                              &height, &count, &channels, 4);
  const std::unique_ptr<stbi_uc, void (*)(void*)> owner(pixels, stbi_image_free);
  const std::unique_ptr<int, void (*)(void*)> delay_owner(delays, stbi_image_free);
  if (!pixels) throw std::runtime_error(stbi_failure_reason());
  Decoded made;
  const std::size_t size = std::size_t(width) * std::size_t(height) * 4;
  for (int i = 0; i < count; ++i) {
    Image image{width, height, {}};
    image.rgba.assign(pixels + std::size_t(i) * size, pixels + std::size_t(i + 1) * size);
    made.frames.push_back(std::move(image));
    made.milliseconds.push_back(delays[i]);
  }
  return made;
}

Image plain(int width, int height, std::array<std::uint8_t, 3> colour) {
  Image image{width, height, {}};
  for (int i = 0; i < width * height; ++i)
    image.rgba.insert(image.rgba.end(), {colour[0], colour[1], colour[2], 255});
  return image;
}

void fill(Image& image, int left, int top, int right, int bottom,
          std::array<std::uint8_t, 3> colour) {
  for (int y = top; y < bottom; ++y)
    for (int x = left; x < right; ++x)
      for (std::size_t k = 0; k < 3; ++k)
        image.rgba[4 * (std::size_t(y) * std::size_t(image.width) + std::size_t(x)) + k] =
            colour[k];
}

TEST(Gif, FewColoursComeBackAsTheyWere) {
  std::vector<Image> frames(4, plain(61, 37, {240, 245, 250}));
  fill(frames[1], 5, 6, 20, 30, {200, 30, 40});
  fill(frames[2], 10, 6, 25, 30, {200, 30, 40});
  fill(frames[2], 40, 0, 61, 37, {0, 114, 178});
  const Decoded back = decoded(gif_bytes(frames, 0.25));
  ASSERT_EQ(back.frames.size(), frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(back.frames[i].rgba, frames[i].rgba) << "frame " << i;
    EXPECT_EQ(back.milliseconds[i], 250);
  }
}

TEST(Gif, ManyColoursComeBackNearly) {
  Image image{128, 96, {}};
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 128; ++x)
      image.rgba.insert(image.rgba.end(),
                        {std::uint8_t(2 * x), std::uint8_t(2 * y), std::uint8_t(x + y), 255});
  const Decoded back = decoded(gif_bytes({image}, 0.1));
  double worst = 0;
  for (std::size_t i = 0; i < image.rgba.size(); ++i)
    worst = std::max(worst, std::abs(double(image.rgba[i]) - double(back.frames[0].rgba[i])));
  EXPECT_LE(worst, 24);
  EXPECT_LE(Palette({image}).colours().size(), 255u);
}

TEST(Gif, NoiseFillsTheTableOfCodesManyTimes) {
  std::mt19937 random(7);
  const std::array<std::array<std::uint8_t, 3>, 4> colours{
      {{0, 0, 0}, {255, 255, 255}, {255, 0, 0}, {0, 128, 255}}};
  // Lengths around every step in the length of codes.
  for (const int width : {1, 2, 3, 255, 256, 257, 508, 509, 510, 511, 512, 700}) {
    Image image{width, 40, {}};
    for (int i = 0; i < width * 40; ++i) {
      const auto& c = colours[random() % 4];
      image.rgba.insert(image.rgba.end(), {c[0], c[1], c[2], 255});
    }
    EXPECT_EQ(decoded(gif_bytes({image}, 0.1)).frames.at(0).rgba, image.rgba) << width;
  }
}

TEST(Gif, EveryLengthOfOneColour) {
  for (int width = 1; width < 300; ++width) {
    const Image image = plain(width, 3, {10, 20, 30});
    ASSERT_EQ(decoded(gif_bytes({image}, 0.1)).frames.at(0).rgba, image.rgba) << width;
  }
}

TEST(Gif, WhatCannotBeIsRefused) {
  EXPECT_THROW(gif_bytes({}, 0.1), std::invalid_argument);
  EXPECT_THROW(gif_bytes({plain(3, 3, {}), plain(3, 4, {})}, 0.1), std::invalid_argument);
  EXPECT_THROW(gif_bytes({plain(0, 3, {})}, 0.1), std::invalid_argument);
}

}  // namespace
}  // namespace sectile::viewer
