// Meshes for the tests of readers and writers, and files in memory.
#pragma once

#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>
#include <string>

#include "sectile/errors.h"
#include "sectile/files.h"

namespace sectile::test {

inline PolygonMesh read(const std::string& content, FileFormat format) {
  std::istringstream in(content);
  return read_mesh(in, format, "file");
}

inline std::string written(const PolygonMesh& mesh, FileFormat format) {
  std::ostringstream out;
  write_mesh(out, format, mesh, "file");
  return std::move(out).str();
}

/// The message with which the file is refused; empty if it is read.
inline std::string refusal(const std::string& content, FileFormat format) {
  try {
    read(content, format);
  } catch (const FileError& error) {
    return error.what();
  }
  return {};
}

/// To the bit: -0 is not 0.
inline bool same_bits(const PolygonMesh& a, const PolygonMesh& b) {
  return a.face_sizes == b.face_sizes && a.indices == b.indices &&
         a.positions.size() == b.positions.size() &&
         (a.positions.empty() || std::memcmp(a.positions.data(), b.positions.data(),
                                             a.positions.size() * sizeof(Vec3)) == 0);
}

inline PolygonMesh tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          {3, 3, 3, 3},
          {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}};
}

/// Triangles over coordinates that suffer from any rounding but the right one.
inline PolygonMesh awkward_triangles() {
  using Limits = std::numeric_limits<double>;
  const double values[] = {0.1,
                           1.0 / 3,
                           std::nextafter(1.0, 2),
                           -0.0,
                           Limits::denorm_min(),
                           Limits::min(),
                           Limits::max(),
                           -Limits::max(),
                           9007199254740993.0,
                           5e-324,
                           2.2250738585072011e-308,
                           1.7976931348623157e308,
                           123456789.12345679,
                           -6.02214076e23,
                           std::nextafter(0.1, 1),
                           4.35e-200,
                           std::acos(-1.0),
                           -1e22};
  PolygonMesh mesh;
  for (int i = 0; i + 2 < 18; i += 3)
    mesh.positions.push_back({values[i], values[i + 1], values[i + 2]});
  // Numbers with all their digits: the fractional parts of multiples of the golden section.
  for (int i = 1; i < 600; i += 3) {
    const auto digits = [](int n) {
      return std::fmod(n * 0.6180339887498949, 1.0) * std::pow(10, n % 40 - 20);
    };
    mesh.positions.push_back({digits(i), -digits(i + 1), digits(i + 2)});
  }
  for (std::uint32_t i = 0; i + 2 < mesh.positions.size(); ++i) {
    mesh.face_sizes.push_back(3);
    mesh.indices.insert(mesh.indices.end(), {i, i + 1, i + 2});
  }
  return mesh;
}

/// A prism whose caps have this many corners.
inline PolygonMesh prism(std::uint32_t corners) {
  PolygonMesh mesh;
  for (const double z : {0.0, 1.0})
    for (std::uint32_t i = 0; i < corners; ++i) {
      const double angle = 2 * std::acos(-1.0) * i / corners;
      mesh.positions.push_back({std::cos(angle), std::sin(angle), z});
    }
  mesh.face_sizes.assign(2, corners);
  for (std::uint32_t i = corners; i-- > 0;) mesh.indices.push_back(i);
  for (std::uint32_t i = 0; i < corners; ++i) mesh.indices.push_back(corners + i);
  for (std::uint32_t i = 0; i < corners; ++i) {
    const std::uint32_t next = (i + 1) % corners;
    mesh.face_sizes.push_back(4);
    mesh.indices.insert(mesh.indices.end(), {i, next, corners + next, corners + i});
  }
  return mesh;
}

/// A mesh with the triangles' corners as STL has them: each a position of its own.
inline PolygonMesh unshared(const PolygonMesh& mesh) {
  PolygonMesh apart;
  apart.face_sizes = mesh.face_sizes;
  for (const std::uint32_t index : mesh.indices) {
    apart.indices.push_back(static_cast<std::uint32_t>(apart.positions.size()));
    apart.positions.push_back(mesh.positions[index]);
  }
  return apart;
}

}  // namespace sectile::test
