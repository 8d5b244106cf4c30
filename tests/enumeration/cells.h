// Sets of unit cells of a grid, as meshes of the squares between inside and outside.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "sectile/mesh.h"

namespace sectile::test {

/// How the squares of a set of cells become a mesh.
enum class Meshing {
  shared,     ///< squares with shared vertices: non-manifold where cells touch in edges or corners
  triangles,  ///< each square as two triangles
  own         ///< triangles with vertices of their own
};

class CellSet {
 public:
  explicit CellSet(int size) : size_(size), cells_(static_cast<std::size_t>(size * size * size)) {}
  /// The subset of the 2×2×2 grid in which bit x + 2y + 4z says whether a cell is in.
  static CellSet of_mask(unsigned mask) {
    CellSet set(2);
    for (unsigned i = 0; i < 8; ++i) set.cells_[i] = mask >> i & 1u;
    return set;
  }

  int size() const { return size_; }
  bool has(int x, int y, int z) const {
    return x >= 0 && y >= 0 && z >= 0 && x < size_ && y < size_ && z < size_ && cells_[at(x, y, z)];
  }
  void set(int x, int y, int z, bool in) { cells_[at(x, y, z)] = in; }

  double volume() const {
    double sum = 0;
    for (const bool in : cells_) sum += in;
    return sum;
  }
  double area() const {
    double sum = 0;
    for_each_square([&](const std::array<std::array<int, 3>, 4>&) { ++sum; });
    return sum;
  }

  /// Calls visit(corners) for each square of the boundary, counter-clockwise from outside.
  template <class Visit>
  void for_each_square(const Visit& visit) const {
    for (int z = 0; z < size_; ++z)
      for (int y = 0; y < size_; ++y)
        for (int x = 0; x < size_; ++x)
          if (has(x, y, z))
            for (int axis = 0; axis < 3; ++axis)
              for (const int step : {-1, 1}) visit_side({x, y, z}, axis, step, visit);
  }

  PolygonMesh mesh(Meshing how) const {
    PolygonMesh mesh;
    std::map<std::array<int, 3>, std::uint32_t> known;
    const auto vertex = [&](const std::array<int, 3>& p) {
      const auto next = static_cast<std::uint32_t>(mesh.positions.size());
      if (how != Meshing::own) {
        const auto [entry, made] = known.try_emplace(p, next);
        if (!made) return entry->second;
      }
      mesh.positions.push_back({double(p[0]), double(p[1]), double(p[2])});
      return next;
    };
    for_each_square([&](const std::array<std::array<int, 3>, 4>& square) {
      std::array<std::uint32_t, 4> v;
      for (std::size_t i = 0; i < 4; ++i) v[i] = vertex(square[i]);
      if (how == Meshing::shared) {
        mesh.face_sizes.push_back(4);
        mesh.indices.insert(mesh.indices.end(), v.begin(), v.end());
      } else {
        for (const std::size_t i : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(v[i]);
        mesh.face_sizes.insert(mesh.face_sizes.end(), 2, 3);
      }
    });
    return mesh;
  }

 private:
  std::size_t at(int x, int y, int z) const {
    return static_cast<std::size_t>(x + size_ * (y + size_ * z));
  }

  template <class Visit>
  void visit_side(const std::array<int, 3>& cell, int axis, int step, const Visit& visit) const {
    auto beyond = cell;
    beyond[static_cast<std::size_t>(axis)] += step;
    if (has(beyond[0], beyond[1], beyond[2])) return;
    const auto u = static_cast<std::size_t>((axis + 1) % 3),
               v = static_cast<std::size_t>((axis + 2) % 3);
    constexpr int around[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    std::array<std::array<int, 3>, 4> square;
    for (std::size_t i = 0; i < 4; ++i) {
      auto& corner = square[step > 0 ? i : 3 - i];
      corner = cell;
      corner[static_cast<std::size_t>(axis)] += step > 0;
      corner[u] += around[i][0];
      corner[v] += around[i][1];
    }
    visit(square);
  }

  int size_;
  std::vector<bool> cells_;
};

}  // namespace sectile::test
