// Animated pictures (GIF 89a), written by hand: one palette for all frames, made from their
// colours, and only what changes from frame to frame.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "render/graphics_context.h"

namespace sectile::viewer {

/// Up to 255 colours for some pictures, by median cut.
class Palette {
 public:
  explicit Palette(const std::vector<Image>& images);
  const std::vector<std::array<std::uint8_t, 3>>& colours() const { return colours_; }
  std::uint8_t nearest(std::uint8_t red, std::uint8_t green, std::uint8_t blue) const {
    return nearest_[cell(red, green, blue)];
  }

 private:
  static std::size_t cell(std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
    return static_cast<std::size_t>(red >> 3) << 11 | static_cast<std::size_t>(green >> 2) << 5 |
           blue >> 3;
  }
  std::vector<std::array<std::uint8_t, 3>> colours_;
  std::vector<std::uint8_t> nearest_;  // by cell: five, six and five bits
};

/// The bytes of a GIF file that plays for ever. All frames are of the first one's size; throws
/// std::invalid_argument if they are not, if there is none or if it is larger than 65535.
std::string gif_bytes(const std::vector<Image>& frames, double seconds_per_frame);

/// Written whole or not at all. Throws FileError, and what gif_bytes throws.
void write_gif(const std::string& path, const std::vector<Image>& frames, double seconds_per_frame);

}  // namespace sectile::viewer
