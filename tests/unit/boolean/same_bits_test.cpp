// Results are the same to the last bit for any number of threads, on operands that are large enough
// to keep all of them busy.
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "sectile/boolean.h"
#include "storage/solid_data.h"

namespace sectile {
namespace {

class Hash {
 public:
  void add(std::uint64_t value) {
    for (int i = 0; i < 8; ++i, value >>= 8) state_ = (state_ ^ (value & 0xFF)) * 0x100000001B3u;
  }
  void add(const Vec3& p) {
    for (const double at : {p.x, p.y, p.z}) add(std::bit_cast<std::uint64_t>(at));
  }
  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0xCBF29CE484222325u;
};

// Everything that the result is stored in, in the order in which it is.
std::uint64_t hash_of_storage(const Solid& solid) {
  const Brep& brep = solid.data()->brep();
  const Geometry& geometry = solid.data()->geometry();
  Hash hash;
  for (const VertexId v : brep.origin) hash.add(v.value());
  for (const HalfEdgeId h : brep.next) hash.add(h.value());
  for (const LoopId l : brep.loop) hash.add(l.value());
  for (const FaceId f : brep.loop_face) hash.add(f.value());
  for (const PlaneId s : brep.plane) hash.add(s.value());
  for (const FaceSource& s : brep.source) hash.add(s.face);
  for (const PointId p : brep.point) hash.add(p.value());
  for (const Vec3& p : geometry.positions) hash.add(p);
  for (const PlaneDefinition& s : geometry.planes)
    for (const std::uint32_t part : {s.a, s.b, s.c}) hash.add(part);
  return hash.value();
}

// The polygons, whatever their order: a number that is the same for all ways to store the result.
std::uint64_t hash_of_polygons(const Solid& solid) {
  const Brep& brep = solid.data()->brep();
  const Geometry& geometry = solid.data()->geometry();
  std::uint64_t sum = 0;
  for (const HalfEdgeId start : brep.loop_half_edge) {
    std::vector<std::uint64_t> corners;
    HalfEdgeId h = start;
    do {
      Hash corner;
      corner.add(geometry.position(brep.point_of(brep.from(h))));
      corners.push_back(corner.value());
      h = brep.next_of(h);
    } while (h != start);
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    Hash loop;
    for (const std::uint64_t corner : corners) loop.add(corner);
    sum += loop.value();
  }
  return sum;
}

// A slab whose upper side is rough; all coordinates are integers, and no two neighbours are flat.
PolygonMesh rough_slab(std::uint32_t cells, std::uint32_t seed, double shift, double bottom,
                       double top) {
  PolygonMesh mesh;
  const std::uint32_t row = cells + 1;
  for (const bool upper : {false, true})
    for (std::uint32_t y = 0; y < row; ++y)
      for (std::uint32_t x = 0; x < row; ++x) {
        seed = seed * 1664525u + 1013904223u;
        mesh.positions.push_back({16.0 * x + shift, 16.0 * y + shift,
                                  upper ? top + static_cast<double>(seed >> 25) : bottom});
      }
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.face_sizes.push_back(3);
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
  };
  const std::uint32_t above = row * row;
  for (std::uint32_t y = 0; y < cells; ++y)
    for (std::uint32_t x = 0; x < cells; ++x) {
      const std::uint32_t p = y * row + x, q = p + 1, r = p + row, s = r + 1;
      add(p, s, q);
      add(p, r, s);
      add(above + p, above + q, above + s);
      add(above + p, above + s, above + r);
    }
  const auto wall = [&](std::uint32_t from, std::uint32_t to) {
    add(from, to, above + to);
    add(from, above + to, above + from);
  };
  for (std::uint32_t i = 0; i < cells; ++i) {
    wall(i, i + 1);
    wall(cells * row + i + 1, cells * row + i);
    wall((i + 1) * row, i * row);
    wall(i * row + cells, (i + 1) * row + cells);
  }
  return mesh;
}

struct Made {
  std::uint64_t storage = 0, polygons = 0;
  friend bool operator==(const Made&, const Made&) = default;
};

// Operands that were never used before, so that their trees are made by so many threads, too.
Made made_by(int threads, Operation operation) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);
  return arena.execute([&] {
    const Solid a = Solid::from_mesh(rough_slab(70, 1, 0, -1000, 0));
    const Solid b = Solid::from_mesh(rough_slab(70, 2, 5, -900, 3));
    const Solid result = boolean(a, b, operation);
    return Made{hash_of_storage(result), hash_of_polygons(result)};
  });
}

class SameBits : public testing::TestWithParam<std::pair<Operation, std::uint64_t>> {};

TEST_P(SameBits, ForAnyNumberOfThreads) {
  const auto [operation, recorded] = GetParam();
  const Made by_one = made_by(1, operation);
  EXPECT_EQ(by_one.polygons, recorded);
  for (const int threads : {2, 8, 8, 8}) EXPECT_EQ(made_by(threads, operation), by_one);
}

INSTANTIATE_TEST_SUITE_P(Operations, SameBits,
                         testing::Values(std::pair(Operation::unite, 18100002756849850158ull),
                                         std::pair(Operation::intersect, 14887977164967093380ull),
                                         std::pair(Operation::subtract, 222026113072765052ull)),
                         [](const auto& test) {
                           const Operation operation = test.param.first;
                           return operation == Operation::unite       ? "Union"
                                  : operation == Operation::intersect ? "Intersection"
                                                                      : "Difference";
                         });

}  // namespace
}  // namespace sectile
