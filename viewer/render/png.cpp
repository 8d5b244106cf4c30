// PNG files.
#include <stb_image.h>
#include <stb_image_write.h>

#include <stdexcept>

#include "render/renderer.h"
#include "sectile/files.h"

namespace sectile::viewer {
namespace {

void append(void* bytes, void* data, int size) {
  auto& target = *static_cast<std::vector<char>*>(bytes);
  const char* start = static_cast<const char*>(data);
  target.insert(target.end(), start, start + size);
}

}  // namespace

void write_png(const std::string& path, const Image& image) {
  const std::size_t needed =
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4;
  if (image.width <= 0 || image.height <= 0 || image.rgba.size() != needed)
    throw std::runtime_error("no picture to write to " + path);
  std::vector<char> bytes;
  if (!stbi_write_png_to_func(append, &bytes, image.width, image.height, 4, image.rgba.data(),
                              image.width * 4))
    throw std::runtime_error("cannot make a PNG for " + path);

  write_whole(path, {bytes.data(), bytes.size()});
}

std::string png_of(const Image& image) {
  std::vector<std::uint8_t> rgb;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    rgb.insert(rgb.end(), &image.rgba[i], &image.rgba[i] + 3);
  std::vector<char> bytes;
  if (!stbi_write_png_to_func(append, &bytes, image.width, image.height, 3, rgb.data(),
                              image.width * 3))
    throw std::runtime_error("cannot make a PNG");
  return {bytes.begin(), bytes.end()};
}

Image read_png(const std::string& path) {
  Image image;
  int channels = 0;
  stbi_uc* pixels = stbi_load(path.c_str(), &image.width, &image.height, &channels, 4);
  if (!pixels) throw std::runtime_error("cannot read " + path + ": " + stbi_failure_reason());
  image.rgba.assign(pixels, pixels + static_cast<std::size_t>(image.width) *
                                         static_cast<std::size_t>(image.height) * 4);
  stbi_image_free(pixels);
  return image;
}

}  // namespace sectile::viewer
