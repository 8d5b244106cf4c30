// Meshes of some thousand triangles: so many go straight into blocks.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "sectile/mesh.h"

namespace sectile {

using Shape = std::function<Vec3(double, double)>;

// A grid of places that closes in both directions, or has a pole at either end.
inline PolygonMesh tube(std::uint32_t rings, std::uint32_t sides, bool poles, const Shape& shape) {
  PolygonMesh mesh;
  const std::uint32_t rows = poles ? rings - 1 : rings;
  for (std::uint32_t r = 0; r < rows; ++r)
    for (std::uint32_t s = 0; s < sides; ++s)
      mesh.positions.push_back(shape((r + (poles ? 1.0 : 0.0)) / rings, double(s) / sides));
  const auto at = [&](std::uint32_t r, std::uint32_t s) { return r % rows * sides + s % sides; };
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
    mesh.face_sizes.push_back(3);
  };
  for (std::uint32_t r = 0; r < (poles ? rows - 1 : rows); ++r)
    for (std::uint32_t s = 0; s < sides; ++s) {
      add(at(r, s), at(r + 1, s), at(r + 1, s + 1));
      add(at(r, s), at(r + 1, s + 1), at(r, s + 1));
    }
  if (!poles) return mesh;
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.push_back(shape(0, 0));
  mesh.positions.push_back(shape(1, 0));
  for (std::uint32_t s = 0; s < sides; ++s) {
    add(first, at(0, s), at(0, s + 1));
    add(first + 1, at(rows - 1, s + 1), at(rows - 1, s));
  }
  return mesh;
}

inline Vec3 on_ball(double u, double v) {
  const double a = std::numbers::pi * u, b = 2 * std::numbers::pi * v;
  return {std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)};
}

inline PolygonMesh ball() {
  return tube(46, 50, true, on_ball);
}

inline PolygonMesh boulder(double grid) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> size(0.97, 1.03);
  return tube(46, 50, true, [&](double u, double v) {
    const Vec3 p = on_ball(u, v);
    const double by = size(random);
    const auto rounded = [&](double x) { return grid > 0 ? std::round(x / grid) * grid : x; };
    return Vec3{rounded(by * p.x), rounded(by * p.y), rounded(by * p.z)};
  });
}

// Flat at the top and at one side, where hundreds of triangles are one face.
inline PolygonMesh flattened_ball() {
  return tube(46, 50, true, [](double u, double v) {
    const Vec3 p = on_ball(u, v);
    return Vec3{std::min(p.x, 0.9), p.y, std::min(p.z, 0.875)};
  });
}

inline PolygonMesh ring() {
  return tube(48, 48, false, [](double u, double v) {
    const double a = 2 * std::numbers::pi * u, b = 2 * std::numbers::pi * v;
    const double r = 3 + std::cos(a);
    return Vec3{r * std::cos(b), r * std::sin(b), -std::sin(a)};
  });
}

// Each triangle has corners of its own, and they come in any order.
inline PolygonMesh soup_of(const PolygonMesh& mesh) {
  std::vector<std::uint32_t> order(mesh.face_sizes.size());
  for (std::uint32_t f = 0; f < order.size(); ++f) order[f] = f;
  std::shuffle(order.begin(), order.end(), std::mt19937(3));
  PolygonMesh soup;
  for (const std::uint32_t f : order)
    for (std::size_t k = 0; k < 3; ++k) {
      soup.indices.push_back(static_cast<std::uint32_t>(soup.positions.size()));
      soup.positions.push_back(mesh.positions[mesh.indices[3 * f + (k + f) % 3]]);
    }
  soup.face_sizes.assign(order.size(), 3);
  return soup;
}

// A face without area at the end: it is dropped, but not on the straight way.
inline PolygonMesh with_face_without_area(PolygonMesh mesh) {
  mesh.indices.insert(mesh.indices.end(), {0, 0, 1});
  mesh.face_sizes.push_back(3);
  return mesh;
}

// One beside the other.
inline PolygonMesh both(PolygonMesh mesh, const PolygonMesh& other) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  for (const std::uint32_t i : other.indices) mesh.indices.push_back(first + i);
  mesh.face_sizes.insert(mesh.face_sizes.end(), other.face_sizes.begin(), other.face_sizes.end());
  return mesh;
}

}  // namespace sectile
