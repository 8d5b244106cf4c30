#include "render/gif.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "sectile/files.h"

namespace sectile::viewer {
namespace {

constexpr std::size_t cells = std::size_t{1} << 16;
constexpr std::size_t most_colours = 255;  // one more means: as in the frame before
constexpr std::uint8_t unchanged = 255;
constexpr int bits = 8;

/// A cell's colour, and how many pixels have it.
struct Counted {
  std::array<std::uint8_t, 3> colour;
  std::uint64_t count;
};

std::vector<Counted> histogram(const std::vector<Image>& images) {
  struct Sum {
    std::array<std::uint64_t, 3> sum{};
    std::uint64_t count = 0;
  };
  std::vector<Sum> sums(cells);
  for (const Image& image : images)
    for (std::size_t i = 0; i + 3 < image.rgba.size(); i += 4) {
      const std::uint8_t* p = &image.rgba[i];
      Sum& sum = sums[static_cast<std::size_t>(p[0] >> 3) << 11 |
                      static_cast<std::size_t>(p[1] >> 2) << 5 | p[2] >> 3];
      for (std::size_t k = 0; k < 3; ++k) sum.sum[k] += p[k];
      ++sum.count;
    }
  std::vector<Counted> made;
  for (const Sum& sum : sums) {
    if (sum.count == 0) continue;
    Counted counted{{}, sum.count};
    for (std::size_t k = 0; k < 3; ++k)
      counted.colour[k] = static_cast<std::uint8_t>(sum.sum[k] / sum.count);
    made.push_back(counted);
  }
  return made;
}

/// A part of the histogram; the one that spreads most is divided next.
struct Box {
  std::size_t first, last;
  std::size_t axis = 0;
  double spread = 0;
};

Box box_of(const std::vector<Counted>& colours, std::size_t first, std::size_t last) {
  Box box{first, last, 0, 0};
  double count = 0;
  for (std::size_t i = first; i < last; ++i) count += static_cast<double>(colours[i].count);
  for (std::size_t k = 0; k < 3; ++k) {
    double mean = 0, square = 0;
    for (std::size_t i = first; i < last; ++i) {
      const double value = colours[i].colour[k], weight = static_cast<double>(colours[i].count);
      mean += weight * value, square += weight * value * value;
    }
    const double spread = square - mean * mean / count;
    if (last - first > 1 && spread > box.spread) box.spread = spread, box.axis = k;
  }
  return box;
}

std::array<std::uint8_t, 3> mean_of(const std::vector<Counted>& colours, const Box& box) {
  std::array<double, 3> sum{};
  double count = 0;
  for (std::size_t i = box.first; i < box.last; ++i) {
    const double weight = static_cast<double>(colours[i].count);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += weight * colours[i].colour[k];
    count += weight;
  }
  std::array<std::uint8_t, 3> made{};
  for (std::size_t k = 0; k < 3; ++k)
    made[k] = static_cast<std::uint8_t>(std::lround(sum[k] / count));
  return made;
}

void put_16(std::string& out, std::size_t value) {
  out += static_cast<char>(value & 255);
  out += static_cast<char>(value >> 8 & 255);
}

/// Codes of growing length, collected into blocks of at most 255 bytes.
class BitWriter {
 public:
  explicit BitWriter(std::string& out) : out_(out) {}
  void put(std::uint32_t code, int length) {
    held_ |= static_cast<std::uint64_t>(code) << held_bits_;
    for (held_bits_ += length; held_bits_ >= 8; held_bits_ -= 8, held_ >>= 8)
      add(static_cast<char>(held_ & 255));
  }
  void end() {
    if (held_bits_ > 0) add(static_cast<char>(held_ & 255));
    flush();
    out_ += '\0';
  }

 private:
  void add(char byte) {
    block_ += byte;
    if (block_.size() == 255) flush();
  }
  void flush() {
    if (block_.empty()) return;
    out_ += static_cast<char>(block_.size());
    out_ += block_;
    block_.clear();
  }
  std::string& out_;
  std::string block_;
  std::uint64_t held_ = 0;
  int held_bits_ = 0;
};

/// The compression of Lempel, Ziv and Welch as GIF has it.
void compress(const std::vector<std::uint8_t>& pixels, std::string& out) {
  constexpr std::uint32_t clear = 1u << bits, end = clear + 1, most = 4096, none = UINT32_MAX;
  // The code of a text one longer, by the code of the text and the pixel.
  std::vector<std::uint16_t> longer(std::size_t{most} << bits);
  out += static_cast<char>(bits);
  BitWriter writer(out);
  std::uint32_t next = end + 1, text = none;
  int length = bits + 1;
  const auto start_again = [&] {
    std::fill(longer.begin(), longer.end(), std::uint16_t{0});
    next = end + 1, length = bits + 1;
  };
  writer.put(clear, length);
  for (const std::uint8_t pixel : pixels) {
    if (text == none) {
      text = pixel;
      continue;
    }
    std::uint16_t& known = longer[(std::size_t{text} << bits) | pixel];
    if (known != 0) {
      text = known;
      continue;
    }
    writer.put(text, length);
    if (next < most) {
      if (next == 1u << length) ++length;
      known = static_cast<std::uint16_t>(next++);
    } else {
      writer.put(clear, length);
      start_again();
    }
    text = pixel;
  }
  writer.put(text, length);
  if (next == 1u << length && length < 12) ++length;
  writer.put(end, length);
  writer.end();
}

std::vector<std::uint8_t> indices_of(const Image& image, const Palette& palette) {
  std::vector<std::uint8_t> made(image.rgba.size() / 4);
  for (std::size_t i = 0; i < made.size(); ++i)
    made[i] = palette.nearest(image.rgba[4 * i], image.rgba[4 * i + 1], image.rgba[4 * i + 2]);
  return made;
}

struct Region {
  std::size_t left = 0, top = 0, width = 1, height = 1;
};

/// The rectangle in which two frames differ; one pixel if they do not.
Region difference(const std::vector<std::uint8_t>& before, const std::vector<std::uint8_t>& now,
                  std::size_t width) {
  std::size_t left = SIZE_MAX, top = SIZE_MAX, right = 0, bottom = 0;
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (now[i] == before[i]) continue;
    const std::size_t x = i % width, y = i / width;
    left = std::min(left, x), right = std::max(right, x);
    top = std::min(top, y), bottom = std::max(bottom, y);
  }
  return left == SIZE_MAX ? Region() : Region{left, top, right - left + 1, bottom - top + 1};
}

void put_header(std::string& out, const Image& first, const Palette& palette) {
  out += "GIF89a";
  put_16(out, static_cast<std::size_t>(first.width));
  put_16(out, static_cast<std::size_t>(first.height));
  out += static_cast<char>(0xF7);  // a palette of 256 colours
  out.append(2, '\0');
  for (std::size_t i = 0; i < 256; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      out += i < palette.colours().size() ? static_cast<char>(palette.colours()[i][k]) : '\0';
  out.append("\x21\xFF\x0BNETSCAPE2.0\x03\x01\0\0\0", 19);  // plays for ever
}

void put_frame(std::string& out, const std::vector<std::uint8_t>& before,
               const std::vector<std::uint8_t>& now, std::size_t width, std::size_t hundredths) {
  const Region region =
      before.empty() ? Region{0, 0, width, now.size() / width} : difference(before, now, width);
  out.append("\x21\xF9\x04\x05", 4);  // what is transparent stays as it was
  put_16(out, hundredths);
  out += static_cast<char>(unchanged);
  out += '\0';
  out += '\x2C';
  for (const std::size_t value : {region.left, region.top, region.width, region.height})
    put_16(out, value);
  out += '\0';
  std::vector<std::uint8_t> pixels;
  pixels.reserve(region.width * region.height);
  for (std::size_t y = region.top; y < region.top + region.height; ++y)
    for (std::size_t x = region.left; x < region.left + region.width; ++x) {
      const std::size_t i = y * width + x;
      pixels.push_back(!before.empty() && before[i] == now[i] ? unchanged : now[i]);
    }
  compress(pixels, out);
}

}  // namespace

Palette::Palette(const std::vector<Image>& images) {
  std::vector<Counted> colours = histogram(images);
  std::vector<Box> boxes;
  if (!colours.empty()) boxes.push_back(box_of(colours, 0, colours.size()));
  while (boxes.size() < most_colours) {
    const auto widest = std::max_element(
        boxes.begin(), boxes.end(), [](const Box& a, const Box& b) { return a.spread < b.spread; });
    if (widest == boxes.end() || widest->spread == 0) break;
    const Box box = *widest;
    std::sort(colours.begin() + static_cast<std::ptrdiff_t>(box.first),
              colours.begin() + static_cast<std::ptrdiff_t>(box.last),
              [&](const Counted& a, const Counted& b) {
                return a.colour[box.axis] != b.colour[box.axis]
                           ? a.colour[box.axis] < b.colour[box.axis]
                           : a.colour < b.colour;
              });
    // At the mean: large areas of one colour keep it.
    const double mean = mean_of(colours, box)[box.axis];
    std::size_t middle = box.first + 1;
    while (middle + 1 < box.last && colours[middle].colour[box.axis] <= mean) ++middle;
    *widest = box_of(colours, box.first, middle);
    boxes.push_back(box_of(colours, middle, box.last));
  }
  for (const Box& box : boxes) colours_.push_back(mean_of(colours, box));
  nearest_.assign(cells, 0);
  for (std::size_t b = 0; b < boxes.size(); ++b)
    for (std::size_t i = boxes[b].first; i < boxes[b].last; ++i) {
      const auto& c = colours[i].colour;
      nearest_[cell(c[0], c[1], c[2])] = static_cast<std::uint8_t>(b);
    }
}

std::string gif_bytes(const std::vector<Image>& frames, double seconds_per_frame) {
  if (frames.empty()) throw std::invalid_argument("An animation needs at least one frame.");
  const Image& first = frames.front();
  for (const Image& frame : frames)
    if (frame.width != first.width || frame.height != first.height || first.width <= 0 ||
        first.width > 65535 || first.height <= 0 || first.height > 65535)
      throw std::invalid_argument("All frames must have one size, of 65535 pixels at most.");
  const Palette palette(frames);
  std::string out;
  put_header(out, first, palette);
  const auto hundredths =
      static_cast<std::size_t>(std::clamp(std::lround(100 * seconds_per_frame), 2L, 65535L));
  std::vector<std::uint8_t> before;
  for (const Image& frame : frames) {
    std::vector<std::uint8_t> now = indices_of(frame, palette);
    put_frame(out, before, now, static_cast<std::size_t>(first.width), hundredths);
    before = std::move(now);
  }
  return out += '\x3B';
}

void write_gif(const std::string& path, const std::vector<Image>& frames,
               double seconds_per_frame) {
  write_whole(path, gif_bytes(frames, seconds_per_frame));
}

}  // namespace sectile::viewer
