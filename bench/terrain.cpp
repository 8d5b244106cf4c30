#include "terrain.h"

namespace sectile::bench {
namespace {

class Builder {
 public:
  explicit Builder(const Terrain& terrain) : cells_(terrain.cells) {
    for (const bool above : {false, true})
      for (std::uint32_t i = 0; i <= cells_; ++i)
        for (std::uint32_t j = 0; j <= cells_; ++j)
          mesh_.positions.push_back({double(i), double(j), above ? terrain.height(i, j) : 0});
  }

  PolygonMesh run(bool rising) {
    for (std::uint32_t i = 0; i < cells_; ++i) {
      for (std::uint32_t j = 0; j < cells_; ++j) add_cell(i, j, rising);
      add_wall(low(i, 0), low(i + 1, 0));
      add_wall(low(i + 1, cells_), low(i, cells_));
      add_wall(low(0, i + 1), low(0, i));
      add_wall(low(cells_, i), low(cells_, i + 1));
    }
    return std::move(mesh_);
  }

 private:
  std::uint32_t low(std::uint32_t i, std::uint32_t j) const { return i * (cells_ + 1) + j; }
  std::uint32_t above(std::uint32_t low) const { return low + (cells_ + 1) * (cells_ + 1); }

  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh_.indices.insert(mesh_.indices.end(), {a, b, c});
    mesh_.face_sizes.push_back(3);
  }
  // Its corners, in order, are below; c is opposite to a.
  void add_cell(std::uint32_t i, std::uint32_t j, bool rising) {
    const std::uint32_t a = low(i, j), b = low(i + 1, j), c = low(i + 1, j + 1), d = low(i, j + 1);
    add(a, d, c);
    add(a, c, b);
    if (rising) {
      add(above(a), above(b), above(c));
      add(above(a), above(c), above(d));
    } else {
      add(above(a), above(b), above(d));
      add(above(b), above(c), above(d));
    }
  }
  void add_wall(std::uint32_t p, std::uint32_t q) {
    add(p, q, above(q));
    add(p, above(q), above(p));
  }

  std::uint32_t cells_;
  PolygonMesh mesh_;
};

}  // namespace

PolygonMesh terrain_mesh(const Terrain& terrain, bool rising) {
  return Builder(terrain).run(rising);
}

}  // namespace sectile::bench
