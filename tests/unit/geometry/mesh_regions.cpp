#include "unit/geometry/mesh_regions.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

namespace sectile::test {
namespace {

using Edge = std::pair<GridPoint, GridPoint>;
using Cell = std::array<GridPoint, 3>;

// Every square of the grid is cut by both diagonals into four triangles; a square has size 2.
std::vector<Cell> mesh_cells(int width, int height) {
  std::vector<Cell> cells;
  for (int i = 0; i < width; ++i) {
    for (int k = 0; k < height; ++k) {
      const GridPoint centre{2 * i + 1, 2 * k + 1};
      const GridPoint corner[4] = {
          {2 * i, 2 * k}, {2 * i + 2, 2 * k}, {2 * i + 2, 2 * k + 2}, {2 * i, 2 * k + 2}};
      for (int side = 0; side < 4; ++side) {
        cells.push_back({corner[side], corner[(side + 1) % 4], centre});
      }
    }
  }
  return cells;
}

class MeshRegion {
 public:
  MeshRegion(const MeshRegionOptions& options, std::mt19937& random)
      : options_(options), random_(random), cells_(mesh_cells(options.width, options.height)) {
    for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
      for (int side = 0; side < 3; ++side) owner_[edge_of(cell, side)] = cell;
    }
  }

  Region make() {
    grow();
    collect_boundary();
    trace();
    return finish();
  }

 private:
  bool chance(double p) { return std::uniform_real_distribution<>(0, 1)(random_) < p; }
  Edge edge_of(std::size_t cell, int side) const {
    return {cells_[cell][side], cells_[cell][(side + 1) % 3]};
  }
  static Edge reversed(const Edge& edge) { return {edge.second, edge.first}; }

  // Grows from one cell over all that are not blocked; the edges over which it grew keep the region
  // connected whatever becomes a slit.
  void grow() {
    std::vector<bool> blocked(cells_.size());
    for (std::size_t cell = 0; cell < cells_.size(); ++cell)
      blocked[cell] = !chance(options_.filled);
    std::vector<Edge> front;
    const auto take = [&](std::size_t cell) {
      taken_.insert(cell);
      for (int side = 0; side < 3; ++side) front.push_back(edge_of(cell, side));
    };
    take(std::uniform_int_distribution<std::size_t>(0, cells_.size() - 1)(random_));
    while (!front.empty()) {
      const std::size_t pick =
          std::uniform_int_distribution<std::size_t>(0, front.size() - 1)(random_);
      const Edge edge = front[pick];
      front[pick] = front.back();
      front.pop_back();
      const auto other = owner_.find(reversed(edge));
      if (other == owner_.end() || blocked[other->second] || taken_.count(other->second)) continue;
      tree_.insert(edge);
      tree_.insert(reversed(edge));
      take(other->second);
    }
  }

  void collect_boundary() {
    for (const auto& [edge, cell] : owner_) {
      if (!taken_.count(cell)) continue;
      const auto other = owner_.find(reversed(edge));
      if (other == owner_.end() || !taken_.count(other->second)) {
        boundary_.insert(edge);
      } else if (edge < reversed(edge) && !tree_.count(edge) && chance(options_.slits)) {
        boundary_.insert(edge);
        boundary_.insert(reversed(edge));
      }
    }
  }

  // Of the eight directions around a place: counter-clockwise from (1, 0).
  static int direction(const GridPoint& from, const GridPoint& to) {
    const auto unit = [](std::int64_t v) { return v > 0 ? 1 : v < 0 ? -1 : 0; };
    const int x = unit(to.x - from.x), y = unit(to.y - from.y);
    static constexpr int table[3][3] = {{5, 6, 7}, {4, -1, 0}, {3, 2, 1}};
    return table[y + 1][x + 1];
  }

  bool encloses_region(const GridPoint& at) const {
    if (options_.tracing != Tracing::mixed) return options_.tracing == Tracing::region;
    return (at.x * 7 + at.y * 3 + at.x * at.y) % 5 < 2;
  }

  /// The boundary edge that follows: the nearest clockwise of the way back if the corner shall
  /// enclose only region, else the nearest counter-clockwise. Of a slit's two sides the one that
  /// arrives comes first counter-clockwise.
  Edge following(const Edge& edge) const {
    const GridPoint at = edge.second;
    const int back = direction(at, edge.first);
    for (int step = 0; step < 8; ++step) {
      const int wanted = (encloses_region(at) ? back + 7 - step : back + step) % 8;
      for (auto it = boundary_.lower_bound({at, GridPoint{-1, -1}});
           it != boundary_.end() && it->first == at; ++it) {
        if (direction(at, it->second) == wanted) return *it;
      }
    }
    throw std::logic_error("the boundary has an open end");
  }

  void trace() {
    std::set<Edge> rest = boundary_;
    while (!rest.empty()) {
      Loop loop;
      for (Edge edge = *rest.begin(); rest.erase(edge) > 0; edge = following(edge)) {
        loop.push_back(edge.first);
      }
      loops_.push_back(loop);
    }
  }

  Region finish() {
    Region region;
    const std::int64_t shear = options_.sheared ? 3 : 0;
    std::shuffle(loops_.begin(), loops_.end(), random_);
    for (const Loop& loop : loops_) {
      Loop kept;
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const GridPoint& a = loop[(i + loop.size() - 1) % loop.size()];
        const GridPoint &b = loop[i], &c = loop[(i + 1) % loop.size()];
        const bool straight = direction(a, b) == direction(b, c);
        if (straight && chance(options_.straightened)) continue;
        kept.push_back({5 * b.x + shear * b.y, shear * b.x + 7 * b.y});
      }
      region.add(kept);
    }
    return region;
  }

  const MeshRegionOptions& options_;
  std::mt19937& random_;
  std::vector<Cell> cells_;
  std::map<Edge, std::size_t> owner_;
  std::set<std::size_t> taken_;
  std::set<Edge> tree_, boundary_;
  std::vector<Loop> loops_;
};

}  // namespace

Region random_mesh_region(const MeshRegionOptions& options, std::mt19937& random) {
  return MeshRegion(options, random).make();
}

}  // namespace sectile::test
