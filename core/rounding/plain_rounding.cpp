#include "rounding/plain_rounding.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/kernel.h"
#include "parallel/parallel.h"
#include "rounding/block_triangles.h"
#include "search/box_tree.h"
#include "selftest/self_test.h"

namespace sectile {
namespace {

constexpr std::uint32_t none = 0xFFFFFFFFu;

// Where more than this part of the corners moves, the whole is looked at.
constexpr std::size_t least_share = 8;

class PlainRounding {
 public:
  PlainRounding(const SolidData& data, const RoundingGrid& grid, RoundingSteps& steps)
      : data_(data), slots_(data.slots()), grid_(grid), steps_(steps) {}

  std::optional<RoundedMesh> run() {
    if (!most_stay()) return {};
    auto triangles = block_triangles(data_);
    if (!triangles || !triangles->one_shell) return {};
    triangles_ = std::move(*triangles);
    steps_.check();
    round();
    find_moved_triangles();
    if (!moved_.empty() && (!is_legal() || !encloses_volume())) return {};
    RoundedMesh result;
    note_report(result.report);
    result.mesh.positions = std::move(positions_);
    result.mesh.indices = std::move(triangles_.indices);
    result.mesh.face_sizes.assign(triangles_.source.size(), 3);
    result.sources = std::move(triangles_.source);
    return result;
  }

 private:
  struct Moved {
    std::uint32_t vertex;
    Vec3 from;
    bool was_exact;
  };
  using Corners = std::array<std::uint32_t, 3>;

  std::size_t triangle_count() const { return triangles_.source.size(); }
  Corners corners(std::uint32_t t) const {
    const std::size_t i = 3 * std::size_t(t);
    return {triangles_.indices[i], triangles_.indices[i + 1], triangles_.indices[i + 2]};
  }

  // Where most corners move, as they do in floats, the whole has to be tested.
  bool most_stay() const {
    std::vector<std::size_t> moved(slots_.size(), 0), all(slots_.size(), 0);
    parallel::loop(0, slots_.size(), [&](std::size_t s) {
      if (slots_[s].empty()) return;
      const Geometry& g = slots_[s].block->geometry;
      all[s] = g.positions.size();
      for (std::size_t p = 0; p < all[s]; ++p) moved[s] += moves(g, PointId(p));
    });
    const auto sum = [](const auto& counts) {
      return std::accumulate(counts.begin(), counts.end(), std::size_t(0));
    };
    return sum(moved) <= sum(all) / least_share;
  }
  bool moves(const Geometry& g, PointId p) const {
    return !g.is_explicit(p) || !(grid_.nearest(g.position(p)) == g.position(p));
  }

  void round() {
    positions_.resize(triangles_.vertex_count);
    has_moved_.assign(triangles_.vertex_count, 0);
    bounds_.resize(slots_.size());
    has_moved_corner_.assign(slots_.size(), 0);
    std::vector<std::vector<Moved>> moved(slots_.size());
    parallel::loop(0, slots_.size(), [&](std::size_t i) {
      const auto s = static_cast<std::uint32_t>(i);
      if (slots_[s].empty()) return;
      const Brep& brep = slots_[s].block->brep;
      const Geometry& g = slots_[s].block->geometry;
      Bounds bounds;
      for (std::size_t local = 0; local < brep.vertex_count(); ++local) {
        const VertexId v(local);
        const PointId p = brep.point_of(v);
        const Vec3& from = g.position(p);
        const Vec3 to = grid_.nearest(from);
        bounds.add(to);
        const bool stays = g.is_explicit(p) && to == from;
        if (!stays) has_moved_corner_[s] = 1;
        if (!triangles_.owns(s, v)) continue;
        const std::uint32_t number = triangles_.vertex(s, v);
        positions_[number] = to;
        has_moved_[number] = !stays;
        if (!stays) moved[s].push_back({number, from, g.is_explicit(p)});
      }
      bounds_[s] = bounds.box();
    });
    for (const auto& some : moved) moved_.insert(moved_.end(), some.begin(), some.end());
  }

  bool has_moved(std::uint32_t t) const {
    const Corners c = corners(t);
    return (has_moved_[c[0]] | has_moved_[c[1]] | has_moved_[c[2]]) != 0;
  }

  void find_moved_triangles() {
    std::vector<std::vector<std::uint32_t>> found(slots_.size());
    parallel::loop(0, slots_.size(), [&](std::size_t s) {
      if (has_moved_corner_[s] == 0) return;
      for (std::uint32_t t = triangles_.first_triangle[s]; t < triangles_.first_triangle[s + 1];
           ++t)
        if (has_moved(t)) found[s].push_back(t);
    });
    for (const auto& some : found)
      moved_triangles_.insert(moved_triangles_.end(), some.begin(), some.end());
  }

  Box box(std::uint32_t t) const {
    Bounds bounds;
    for (const std::uint32_t v : corners(t)) bounds.add(positions_[v]);
    return bounds.box();
  }

  // The moved triangles and all that may meet them; those of faces that were cut, whose area
  // nobody has looked at.
  std::vector<std::uint32_t> surroundings() const {
    std::vector<Box> boxes(moved_triangles_.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) boxes[i] = box(moved_triangles_[i]);
    const BoxTree tree(boxes);
    std::vector<std::vector<std::uint32_t>> found(slots_.size());
    parallel::loop(0, slots_.size(), [&](std::size_t s) {
      const std::uint32_t begin = triangles_.first_triangle[s],
                          end = triangles_.first_triangle[s + 1];
      const auto meets = [&](const Box& own) {
        bool any = false;
        tree.query([&](const Box& b) { return !any && b.overlaps(own); },
                   [&](std::uint32_t) { any = true; });
        return any;
      };
      if (begin == end || !meets(bounds_[s])) return;
      for (std::uint32_t t = begin; t < end; ++t)
        if (meets(box(t))) found[s].push_back(t);
    });
    std::vector<std::uint32_t> near(triangles_.cut);
    for (const auto& some : found) near.insert(near.end(), some.begin(), some.end());
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    return near;
  }

  // Every pair with a moved triangle is tested. What decides about such a pair is near, too.
  bool is_legal() {
    const std::vector<std::uint32_t> near = surroundings();
    Geometry geometry;
    TriangleSurface surface;
    std::vector<std::uint32_t> point(positions_.size(), none);
    for (std::uint32_t i = 0; i < near.size(); ++i) {
      std::array<PointId, 3> at;
      const Corners c = corners(near[i]);
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& p = positions_[c[k]];
        // Too large for the numbers: refused where everything is looked at.
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return false;
        if (point[c[k]] == none) point[c[k]] = geometry.add_point(p).value();
        at[k] = PointId(point[c[k]]);
      }
      surface.corners.push_back(at);
      surface.plane.push_back(geometry.add_plane(PlaneDefinition::through(at[0], at[1], at[2])));
      surface.face.push_back(i);
      surface.settled.push_back(!has_moved(near[i]));
    }
    find_mates(surface);
    const Kernel kernel(geometry);
    for (const PlaneId plane : surface.plane)
      if (is_flat(kernel, plane)) return false;
    return self_contacts(surface, kernel, steps_.part(0.5)).empty();
  }

  static bool is_flat(const Kernel& kernel, PlaneId plane) {
    for (int axis = 0; axis < 3; ++axis)
      if (kernel.normal(plane, axis) != Sign::zero) return false;
    return true;
  }

  // Beyond the surroundings an edge has no mate.
  static void find_mates(TriangleSurface& surface) {
    struct Edge {
      PointId low, high;
      std::uint32_t triangle, k;
      auto operator<=>(const Edge&) const = default;
    };
    std::vector<Edge> edges;
    surface.mate.resize(surface.size());
    for (std::uint32_t t = 0; t < surface.size(); ++t)
      for (std::uint32_t k = 0; k < 3; ++k) {
        const PointId p = surface.corners[t][k], q = surface.corners[t][k < 2 ? k + 1 : 0];
        edges.push_back({std::min(p, q), std::max(p, q), t, k});
        surface.mate[t][k] = t | TriangleSurface::partial;
      }
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
      const Edge &a = edges[i], &b = edges[i + 1];
      if (a.low != b.low || a.high != b.high) continue;
      surface.mate[a.triangle][a.k] = b.triangle;
      surface.mate[b.triangle][b.k] = a.triangle;
      ++i;
    }
  }

  // Certainly: far more than the rounding errors of the sum.
  bool encloses_volume() const {
    struct Sums {
      double sum = 0, size = 0, reach = 1;
    };
    const Vec3 o = positions_[0];
    constexpr std::size_t block = 4096;
    std::vector<Sums> sums((triangle_count() + block - 1) / block);
    parallel::loop(0, sums.size(), [&](std::size_t b) {
      Sums& mine = sums[b];
      for (std::size_t t = b * block; t < std::min(triangle_count(), (b + 1) * block); ++t) {
        const Corners c = corners(static_cast<std::uint32_t>(t));
        double p[3][3];
        for (std::size_t k = 0; k < 3; ++k) {
          const Vec3& v = positions_[c[k]];
          p[k][0] = v.x - o.x;
          p[k][1] = v.y - o.y;
          p[k][2] = v.z - o.z;
          for (const double along : p[k]) mine.reach = std::max(mine.reach, std::abs(along));
        }
        for (int k = 0; k < 3; ++k) {
          const int i = (k + 1) % 3, j = (k + 2) % 3;
          const double left = p[0][k] * p[1][i] * p[2][j], right = p[0][k] * p[1][j] * p[2][i];
          mine.sum += left - right;
          mine.size += std::abs(left) + std::abs(right);
        }
      }
    });
    Sums all;
    for (const Sums& s : sums) {
      all.sum += s.sum;
      all.size += s.size;
      all.reach = std::max(all.reach, s.reach);
    }
    // Products that underflow are off by the least double times a third factor.
    return all.sum > 0x1p-20 * all.size && all.size > 0x1p-900 * all.reach &&
           triangle_count() < 0x1p28;
  }

  void note_report(RoundingReport& report) const {
    report.corners = positions_.size();
    std::vector<double> moves;
    for (const Moved& m : moved_) {
      const Vec3& to = positions_[m.vertex];
      double move = std::hypot(to.x - m.from.x, to.y - m.from.y, to.z - m.from.z);
      // The place itself is off by half a unit in the last place of each coordinate at most.
      if (!m.was_exact) {
        const double half = 0x1p-53;
        move += std::hypot(half * m.from.x, half * m.from.y, half * m.from.z);
      }
      if (move == 0) continue;
      moves.push_back(move);
      if (move <= report.largest_move) continue;
      report.largest_move = move;
      report.largest_at = m.from;
    }
    report.moved = moves.size();
    if (moves.empty()) return;
    const auto middle = moves.begin() + static_cast<std::ptrdiff_t>(moves.size() / 2);
    std::nth_element(moves.begin(), middle, moves.end());
    report.median_move = *middle;
  }

  const SolidData& data_;
  std::span<const Slot> slots_;
  const RoundingGrid& grid_;
  RoundingSteps& steps_;
  BlockTriangles triangles_;
  std::vector<Vec3> positions_;                 // per vertex
  std::vector<std::uint8_t> has_moved_;         // per vertex
  std::vector<Box> bounds_;                     // per slot
  std::vector<std::uint8_t> has_moved_corner_;  // per slot
  std::vector<Moved> moved_;
  std::vector<std::uint32_t> moved_triangles_;
};

}  // namespace

std::optional<RoundedMesh> plain_rounding(const SolidData& data, const RoundingGrid& grid,
                                          RoundingSteps& steps) {
  return PlainRounding(data, grid, steps).run();
}

}  // namespace sectile
