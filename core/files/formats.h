// The readers and writers of the formats. Readers take a whole file; `name` is for messages.
#pragma once

#include <ostream>
#include <string_view>

#include "sectile/files.h"

namespace sectile {

PolygonMesh read_obj(std::string_view content, std::string_view name);
PolygonMesh read_stl(std::string_view content, std::string_view name);
PolygonMesh read_off(std::string_view content, std::string_view name);
PolygonMesh read_ply(std::string_view content, std::string_view name);

void write_obj(std::ostream& out, const PolygonMesh& mesh);
void write_stl_text(std::ostream& out, const PolygonMesh& mesh);
void write_stl_binary(std::ostream& out, const PolygonMesh& mesh);
void write_off(std::ostream& out, const PolygonMesh& mesh);
void write_ply_text(std::ostream& out, const PolygonMesh& mesh);
void write_ply_binary(std::ostream& out, const PolygonMesh& mesh);

/// The shortest text that reads back as the same double.
std::string shortest(double value);

/// Calls visit(a, b, c) with the corners of each face, as a fan.
template <class Visit>
void for_each_triangle(const PolygonMesh& mesh, const Visit& visit) {
  std::size_t at = 0;
  for (const std::uint32_t size : mesh.face_sizes) {
    for (std::uint32_t i = 1; i + 1 < size; ++i)
      visit(mesh.positions[mesh.indices[at]], mesh.positions[mesh.indices[at + i]],
            mesh.positions[mesh.indices[at + i + 1]]);
    at += size;
  }
}

}  // namespace sectile
