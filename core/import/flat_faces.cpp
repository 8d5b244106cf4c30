// Corners of 0° and faces without area.
//
//    x ---------- d ---- c     The path x, c, d turns back at c. The triangle x c d, which has no
//                              area, is cut off, and the path goes straight from x to d. This takes
//                              faces without area to pieces and leaves nothing of them.
//
// All corners of a flat triangle lie on a line, so its edges cancel each other if each is taken
// piece by piece; the faces on the other sides of its edges only have to know the pieces. Flat
// triangles that share an edge share the line and its pieces.

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "import/polygons.h"
#include "numbers/disjoint_sets.h"
#include "parallel/parallel.h"

namespace sectile {
namespace {

using FlatTriangle = std::array<PointId, 3>;

// The axes, first the one along which the triangle probably shows the largest area.
std::array<int, 3> axes(const Geometry& g, PointId a, PointId b, PointId c) {
  const Vec3 &p = g.position(a), &q = g.position(b), &r = g.position(c);
  const double u[3] = {q.x - p.x, q.y - p.y, q.z - p.z}, v[3] = {r.x - p.x, r.y - p.y, r.z - p.z};
  const double x = std::abs(u[1] * v[2] - u[2] * v[1]), y = std::abs(u[2] * v[0] - u[0] * v[2]),
               z = std::abs(u[0] * v[1] - u[1] * v[0]);
  if (x >= y && x >= z) return {0, 1, 2};
  return y >= z ? std::array{1, 2, 0} : std::array{2, 0, 1};
}

bool collinear(const Kernel& kernel, PointId a, PointId b, PointId c) {
  for (const int axis : axes(kernel.geometry(), a, b, c))
    if (kernel.turn(a, b, c, axis) != Sign::zero) return false;
  return true;
}

/// Does the path x, c, d turn back at c? The points differ.
bool turns_back(const Kernel& kernel, PointId x, PointId c, PointId d) {
  if (!collinear(kernel, x, c, d)) return false;
  for (int axis = 0; axis < 3; ++axis)
    if (const Sign s = kernel.compare(c, x, axis); s != Sign::zero)
      return s == kernel.compare(c, d, axis);
  return true;
}

bool has_flat_corner(const Kernel& kernel, std::span<const PointId> loop) {
  const std::size_t n = loop.size();
  if (n == 3) return collinear(kernel, loop[0], loop[1], loop[2]);
  for (std::size_t i = 0; i < n; ++i)
    if (turns_back(kernel, loop[i], loop[i + 1 < n ? i + 1 : i + 1 - n],
                   loop[i + 2 < n ? i + 2 : i + 2 - n]))
      return true;
  return false;
}

// Faces with flat corners, one flag for each face; empty if there are none.
std::vector<std::uint8_t> find_flat_corners(const Polygons& polygons, const Kernel& kernel) {
  std::vector<std::uint8_t> flat(polygons.face_count(), 0);
  parallel::loop(parallel::Range<std::size_t>(0, flat.size(), 1024), [&](const auto& range) {
    for (std::size_t f = range.begin(); f < range.end(); ++f)
      for (std::uint32_t l = polygons.first_loop(f); l < polygons.face_end[f]; ++l)
        if (has_flat_corner(kernel, polygons.loop(l))) flat[f] = 1;
  });
  if (std::find(flat.begin(), flat.end(), 1) == flat.end()) flat.clear();
  return flat;
}

// A loop from which flat corners are cut off.
class Trimming {
 public:
  Trimming(const Kernel& kernel, std::vector<FlatTriangle>& cut) : kernel_(kernel), cut_(cut) {}

  /// What remains: three corners or more, or nothing.
  std::span<const PointId> run(std::span<const PointId> loop) {
    left_.clear();
    for (const PointId p : loop) {
      left_.push_back(p);
      trim_end();
    }
    first_ = 0;
    while (trim_seam()) {
    }
    if (left_.size() < first_ + 3) return {};
    return std::span(left_).subspan(first_);
  }

 private:
  // Repeated places and 0° corners at the end of the path so far.
  void trim_end() {
    for (std::size_t n = left_.size(); n > 1; n = left_.size()) {
      const PointId last = left_[n - 1];
      if (left_[n - 2] == last) {
        left_.pop_back();
      } else if (n > 2 && is_flat(left_[n - 3], left_[n - 2], last)) {
        left_.erase(left_.end() - 2);
      } else {
        break;
      }
    }
  }
  // The same where the end meets the beginning.
  bool trim_seam() {
    const std::size_t n = left_.size();
    if (n < first_ + 3) return false;
    if (left_[first_] == left_[n - 1] || is_flat(left_[n - 2], left_[n - 1], left_[first_])) {
      left_.pop_back();
      return true;
    }
    if (!is_flat(left_[n - 1], left_[first_], left_[first_ + 1])) return false;
    ++first_;
    return true;
  }
  bool is_flat(PointId x, PointId c, PointId d) {
    if (x == d) return true;
    if (!turns_back(kernel_, x, c, d)) return false;
    cut_.push_back({x, c, d});
    return true;
  }

  const Kernel& kernel_;
  std::vector<FlatTriangle>& cut_;
  std::vector<PointId> left_;
  std::size_t first_ = 0;
};

Polygons without_flat_corners(const Polygons& polygons, const std::vector<std::uint8_t>& flat,
                              const Kernel& kernel, std::vector<FlatTriangle>& cut) {
  Polygons kept;
  Trimming trimming(kernel, cut);
  for (std::size_t f = 0; f < polygons.face_count(); ++f) {
    if (!flat[f]) {
      kept.add_face(polygons, f);
      continue;
    }
    const std::size_t loops_before = kept.loop_end.size();
    for (std::uint32_t l = polygons.first_loop(f); l < polygons.face_end[f]; ++l)
      if (const auto left = trimming.run(polygons.loop(l)); !left.empty()) kept.add_loop(left);
    if (kept.loop_end.size() > loops_before) kept.end_face(polygons.source[f]);
  }
  return kept;
}

// The lines of flat triangles: triangles that share edges lie on one line.
class FlatLines {
 public:
  FlatLines(const std::vector<FlatTriangle>& triangles, const Kernel& kernel) : kernel_(kernel) {
    collect_edges(triangles);
    unite(triangles.size());
    lines_.resize(triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
      auto& points = lines_[sets_.first(t)].points;
      points.insert(points.end(), triangles[t].begin(), triangles[t].end());
    }
    for (Line& line : lines_) {
      sort_along(line.points);
      line.used.resize(line.points.size());
    }
  }

  /// Only where another face has a corner are edges divided.
  void use_corners(const Polygons& polygons) {
    for_each_edge(polygons, [&](PointId a, PointId b) {
      Line* line = line_of(a, b);
      if (!line) return;
      line->used[place(*line, a)] = true;
      line->used[place(*line, b)] = true;
    });
  }

  void divide(Polygons& polygons) {
    Polygons divided;
    for (std::size_t f = 0; f < polygons.face_count(); ++f) {
      for (std::uint32_t l = polygons.first_loop(f); l < polygons.face_end[f]; ++l) {
        const auto loop = polygons.loop(l);
        for (std::size_t i = 0; i < loop.size(); ++i) {
          divided.corners.push_back(loop[i]);
          add_pieces(loop[i], loop[i + 1 < loop.size() ? i + 1 : 0], divided.corners);
        }
        divided.loop_end.push_back(static_cast<std::uint32_t>(divided.corners.size()));
      }
      divided.end_face(polygons.source[f]);
    }
    polygons = std::move(divided);
  }

 private:
  struct Line {
    std::vector<PointId> points;  // in order
    std::vector<bool> used;
  };
  struct Edge {
    PointId low, high;
    std::uint32_t triangle;
    friend bool operator<(const Edge& a, const Edge& b) {
      return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    }
    bool same_place(const Edge& other) const { return low == other.low && high == other.high; }
  };

  void collect_edges(const std::vector<FlatTriangle>& triangles) {
    PointId last(0);
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        const PointId a = triangles[t][i], b = triangles[t][(i + 1) % 3];
        edges_.push_back({std::min(a, b), std::max(a, b), t});
        last = std::max({last, a, b});
      }
    std::sort(edges_.begin(), edges_.end());
    touched_.resize(last.value() + 1);
    for (const Edge& e : edges_) touched_[e.low.value()] = touched_[e.high.value()] = true;
  }
  void unite(std::size_t count) {
    sets_ = DisjointSets(count);
    for (std::size_t i = 1; i < edges_.size(); ++i)
      if (edges_[i].same_place(edges_[i - 1]))
        sets_.unite(edges_[i].triangle, edges_[i - 1].triangle);
  }
  bool precedes(PointId p, PointId q) const {
    for (int axis = 0; axis < 3; ++axis)
      if (const Sign s = kernel_.compare(p, q, axis); s != Sign::zero) return s == Sign::positive;
    return false;
  }
  void sort_along(std::vector<PointId>& points) const {
    std::sort(points.begin(), points.end(),
              [this](PointId p, PointId q) { return precedes(p, q); });
    points.erase(std::unique(points.begin(), points.end()), points.end());
  }
  std::size_t place(const Line& line, PointId p) const {
    const auto at = std::lower_bound(line.points.begin(), line.points.end(), p,
                                     [this](PointId a, PointId b) { return precedes(a, b); });
    return static_cast<std::size_t>(at - line.points.begin());
  }

  bool touches(PointId p) const { return p.value() < touched_.size() && touched_[p.value()]; }
  Line* line_of(PointId a, PointId b) {
    if (!touches(a) || !touches(b)) return nullptr;
    const Edge edge{std::min(a, b), std::max(a, b), 0};
    const auto at = std::lower_bound(edges_.begin(), edges_.end(), edge);
    return at != edges_.end() && at->same_place(edge) ? &lines_[sets_.first(at->triangle)]
                                                      : nullptr;
  }
  template <class Visit>
  static void for_each_edge(const Polygons& polygons, const Visit& visit) {
    for (std::size_t l = 0; l < polygons.loop_end.size(); ++l) {
      const auto loop = polygons.loop(l);
      for (std::size_t i = 0; i < loop.size(); ++i)
        visit(loop[i], loop[i + 1 < loop.size() ? i + 1 : 0]);
    }
  }
  void add_pieces(PointId a, PointId b, std::vector<PointId>& corners) {
    const Line* line = line_of(a, b);
    if (!line) return;
    std::size_t i = place(*line, a);
    const std::size_t end = place(*line, b);
    const std::size_t step = i < end ? 1 : std::size_t(-1);
    for (i += step; i != end; i += step)
      if (line->used[i]) corners.push_back(line->points[i]);
  }

  const Kernel& kernel_;
  std::vector<Edge> edges_;
  std::vector<bool> touched_;  // per point: end of an edge
  DisjointSets sets_{0};
  std::vector<Line> lines_;  // with the number of one of its triangles
};

}  // namespace

void remove_flat_faces(Polygons& polygons, const Kernel& kernel) {
  const std::vector<std::uint8_t> flat = find_flat_corners(polygons, kernel);
  if (flat.empty()) return;
  std::vector<FlatTriangle> cut;
  polygons = without_flat_corners(polygons, flat, kernel, cut);
  if (cut.empty()) return;
  FlatLines lines(cut, kernel);
  lines.use_corners(polygons);
  lines.divide(polygons);
}

}  // namespace sectile
