// What must hold for every file, whatever its bytes.
#pragma once

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <numeric>
#include <string>

#include "files/formats.h"
#include "sectile/errors.h"

namespace sectile::fuzz {

inline void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", what);
  std::abort();
}

inline void require_consistent(const PolygonMesh& mesh) {
  std::uint64_t corners = 0;
  for (const std::uint32_t size : mesh.face_sizes) {
    require(size >= 3, "a face has three corners or more");
    corners += size;
  }
  require(corners == mesh.indices.size(), "sizes and indices fit together");
  for (const std::uint32_t index : mesh.indices)
    require(index < mesh.positions.size(), "every corner has a position");
  for (const Vec3& p : mesh.positions)
    require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z), "finite coordinates");
}

// To the bit: -0 is not 0.
inline void require_same(const PolygonMesh& a, const PolygonMesh& b) {
  require(a.face_sizes == b.face_sizes && a.indices == b.indices, "the same faces read back");
  require(a.positions.size() == b.positions.size() &&
              (a.positions.empty() || std::memcmp(a.positions.data(), b.positions.data(),
                                                  a.positions.size() * sizeof(Vec3)) == 0),
          "the same positions read back");
}

template <class Write>
std::string written(const Write& write) {
  std::string content;
  Sink sink([&](std::string_view text) { content += text; });
  write(sink);
  sink.finish();
  return content;
}

/// Either the reader refuses the file, and says where, or the mesh is consistent and each writer in
/// `round_trip` writes what reads back as the same.
template <class Read, class RoundTrip>
int read_anything(const std::uint8_t* data, std::size_t size, const Read& read,
                  const RoundTrip& round_trip) {
  const std::string_view content(reinterpret_cast<const char*>(data), size);
  PolygonMesh mesh;
  try {
    mesh = read(content, "file");
  } catch (const FileError& error) {
    const std::string_view message = error.what();
    require(message.starts_with("file:") && message.size() > 7, "errors say where");
    return 0;
  }
  require_consistent(mesh);
  round_trip(mesh);
  return 0;
}

}  // namespace sectile::fuzz
