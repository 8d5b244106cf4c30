#include "unit/import/cell_mesh.h"

#include <algorithm>
#include <map>

#include "append_mesh.h"

namespace sectile {

PolygonMesh cell_mesh(const std::set<Cell>& cells, bool inwards) {
  PolygonMesh mesh;
  std::map<Cell, std::uint32_t> number;
  const auto vertex = [&](const Cell& at) {
    const auto [entry, added] =
        number.try_emplace(at, static_cast<std::uint32_t>(mesh.positions.size()));
    if (added) mesh.positions.push_back({double(at[0]), double(at[1]), double(at[2])});
    return entry->second;
  };
  for (const Cell& cell : cells)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int side : {0, 1}) {
        Cell beside = cell;
        beside[axis] += 2 * side - 1;
        if (cells.contains(beside)) continue;
        const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        std::array<std::uint32_t, 4> square;
        for (std::size_t k = 0; k < 4; ++k) {
          Cell corner = cell;
          corner[axis] += side;
          corner[u] += k == 1 || k == 2;
          corner[v] += k >= 2;
          square[k] = vertex(corner);
        }
        if ((side == 0) != inwards) std::reverse(square.begin(), square.end());
        mesh.face_sizes.push_back(4);
        mesh.indices.insert(mesh.indices.end(), square.begin(), square.end());
      }
  return mesh;
}

PolygonMesh cube_mesh(const Vec3& low, double size) {
  std::vector<Vec3> positions;
  for (const double z : {0.0, 1.0})
    for (const auto& [x, y] : {std::pair(0.0, 0.0), {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}})
      positions.push_back({low.x + size * x, low.y + size * y, low.z + size * z});
  return with_faces(
      std::move(positions),
      {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
}

PolygonMesh joined(const PolygonMesh& a, const PolygonMesh& b) {
  PolygonMesh mesh = a;
  test::append(b, mesh);
  return mesh;
}

PolygonMesh turned_over(const PolygonMesh& mesh) {
  auto faces = faces_of(mesh);
  for (auto& face : faces) std::reverse(face.begin(), face.end());
  return with_faces(mesh.positions, faces);
}

std::vector<std::vector<std::uint32_t>> faces_of(const PolygonMesh& mesh) {
  std::vector<std::vector<std::uint32_t>> faces;
  auto corner = mesh.indices.begin();
  for (const std::uint32_t n : mesh.face_sizes) {
    faces.emplace_back(corner, corner + n);
    corner += n;
  }
  return faces;
}

PolygonMesh with_faces(std::vector<Vec3> positions,
                       const std::vector<std::vector<std::uint32_t>>& faces) {
  PolygonMesh mesh{std::move(positions), {}, {}};
  for (const auto& face : faces) {
    mesh.face_sizes.push_back(static_cast<std::uint32_t>(face.size()));
    mesh.indices.insert(mesh.indices.end(), face.begin(), face.end());
  }
  return mesh;
}

}  // namespace sectile
