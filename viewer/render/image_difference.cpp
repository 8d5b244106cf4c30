#include "render/image_difference.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sectile::viewer {
namespace {

using Pixel = std::array<float, 3>;

struct Plane {
  int width, height;
  std::vector<Pixel> pixels;
  const Pixel& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(std::clamp(y, 0, height - 1)) *
                      static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(std::clamp(x, 0, width - 1))];
  }
};

Plane plane_of(const Image& image) {
  Plane plane{image.width, image.height, std::vector<Pixel>(image.rgba.size() / 4)};
  for (std::size_t i = 0; i < plane.pixels.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      plane.pixels[i][c] = static_cast<float>(image.rgba[4 * i + c]) / 255;
  return plane;
}

// Weights 1 2 1 along one direction.
Plane blurred(const Plane& plane, int dx, int dy) {
  Plane result = plane;
  for (int y = 0; y < plane.height; ++y) {
    for (int x = 0; x < plane.width; ++x) {
      Pixel& target =
          result.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(plane.width) +
                        static_cast<std::size_t>(x)];
      const Pixel &before = plane.at(x - dx, y - dy), &here = plane.at(x, y),
                  &after = plane.at(x + dx, y + dy);
      for (std::size_t c = 0; c < 3; ++c) target[c] = (before[c] + 2 * here[c] + after[c]) / 4;
    }
  }
  return result;
}

// The eye sees differences of green most and of blue least.
float distance(const Pixel& a, const Pixel& b) {
  constexpr Pixel weights{0.35f, 0.5f, 0.15f};
  float sum = 0;
  for (std::size_t c = 0; c < 3; ++c) sum += weights[c] * (a[c] - b[c]) * (a[c] - b[c]);
  return std::sqrt(sum);
}

Plane softened(const Image& image) {
  return blurred(blurred(plane_of(image), 1, 0), 0, 1);
}

// To the pixel of the other picture, at the same place or beside it, that is most alike.
float distance_nearby(const Pixel& pixel, const Plane& other, int x, int y) {
  float least = 1;
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      least = std::min(least, distance(pixel, other.at(x + dx, y + dy)));
  return least;
}

constexpr int square = 8;

double sum_of_square(const std::vector<float>& values, int width, int left, int top) {
  double sum = 0;
  for (int y = top; y < top + square; ++y)
    for (int x = left; x < left + square; ++x)
      sum +=
          static_cast<double>(values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                     static_cast<std::size_t>(x)]);
  return sum;
}

void paint(Image& picture, std::size_t i, const Pixel& original, float difference) {
  const float grey = 0.75f + 0.2f * (original[0] + original[1] + original[2]) / 3;
  const float red = std::min(1.0f, 4 * difference);
  const Pixel colour{grey + (1 - grey) * red, grey * (1 - red), grey * (1 - red)};
  for (std::size_t c = 0; c < 3; ++c)
    picture.rgba[4 * i + c] = static_cast<std::uint8_t>(std::lround(255 * colour[c]));
  picture.rgba[4 * i + 3] = 255;
}

}  // namespace

ImageDifference compare_images(const Image& a, const Image& b, double threshold) {
  if (a.width != b.width || a.height != b.height) return {1, 1, {}};
  const Plane first = softened(a);
  const Plane second = softened(b);
  ImageDifference result;
  result.picture = {a.width, a.height, std::vector<std::uint8_t>(a.rgba.size())};
  if (first.pixels.empty()) return result;
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < first.pixels.size(); ++i) {
    const float difference = distance(first.pixels[i], second.pixels[i]);
    result.mean += static_cast<double>(difference);
    if (static_cast<double>(difference) > threshold) ++beyond;
    paint(result.picture, i, first.pixels[i], difference);
  }
  result.mean /= static_cast<double>(first.pixels.size());
  result.share = static_cast<double>(beyond) / static_cast<double>(first.pixels.size());
  return result;
}

LocalDifference compare_locally(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height) return {1, 0, 0, {}};
  const Plane first = softened(a), second = softened(b);
  LocalDifference result;
  result.picture = {a.width, a.height, std::vector<std::uint8_t>(a.rgba.size())};
  std::vector<float> differences(first.pixels.size());
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(a.width) +
                            static_cast<std::size_t>(x);
      // What is missing in either counts.
      if (distance(first.pixels[i], second.pixels[i]) > 0.01f)
        differences[i] = std::max(distance_nearby(first.pixels[i], second, x, y),
                                  distance_nearby(second.pixels[i], first, x, y));
      paint(result.picture, i, first.pixels[i], differences[i]);
    }
  }
  for (int y = 0; y + square <= a.height; y += square / 4) {
    for (int x = 0; x + square <= a.width; x += square / 4) {
      const double mean = sum_of_square(differences, a.width, x, y) / (square * square);
      if (mean <= result.worst) continue;
      result.worst = mean;
      result.x = x;
      result.y = y;
    }
  }
  return result;
}

}  // namespace sectile::viewer
