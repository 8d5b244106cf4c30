#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "geometry/face_predicates.h"
#include "geometry/triangulation.h"
#include "import/polygons.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

struct View {
  int axis;
  bool behind;
};

// The axes along which the face shows any area, the largest first.
std::vector<View> views(const Geometry& g, const Polygons& polygons, std::size_t f) {
  double n[3] = {0, 0, 0};
  for (std::uint32_t l = polygons.first_loop(f); l < polygons.face_end[f]; ++l) {
    const auto loop = polygons.loop(l);
    const Vec3 o = g.position(loop[0]);
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
      const Vec3 &p = g.position(loop[i]), &q = g.position(loop[i + 1]);
      const double u[3] = {p.x - o.x, p.y - o.y, p.z - o.z},
                   v[3] = {q.x - o.x, q.y - o.y, q.z - o.z};
      for (int k = 0; k < 3; ++k)
        n[k] += u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
    }
  }
  std::vector<View> result;
  for (int k = 0; k < 3; ++k)
    if (n[k] != 0) result.push_back({k, n[k] < 0});
  std::sort(result.begin(), result.end(), [&](const View& a, const View& b) {
    return std::abs(n[a.axis]) > std::abs(n[b.axis]);
  });
  return result;
}

using Triangle = std::array<PointId, 3>;

// Half-edges that are to cancel each other, if they run both ways between the same points.
class Boundary {
 public:
  void add(PointId from, PointId to) {
    if (from != to) edges_.push_back({std::min(from, to), std::max(from, to), from < to});
  }
  void add(const Triangle& t) {
    for (int i = 0; i < 3; ++i) add(t[i], t[(i + 1) % 3]);
  }
  void add_reversed(std::span<const PointId> loop) {
    for (std::size_t i = 0; i < loop.size(); ++i)
      add(loop[i + 1 < loop.size() ? i + 1 : 0], loop[i]);
  }

  /// What does not cancel, as closed paths.
  std::vector<std::vector<PointId>> rest() {
    cancel();
    std::sort(left_.begin(), left_.end());
    taken_.assign(left_.size(), 0);
    std::vector<std::vector<PointId>> paths;
    for (std::size_t i = 0; i < left_.size(); ++i) {
      const PointId start = left_[i].first;
      if (first_from(start) + taken_[first_from(start)] > i) continue;
      paths.push_back({start});
      for (PointId at = take(start); at != start; at = take(at)) paths.back().push_back(at);
    }
    return paths;
  }

 private:
  struct Edge {
    PointId low, high;
    bool forward;
    auto operator<=>(const Edge&) const = default;
  };

  void cancel() {
    std::sort(edges_.begin(), edges_.end());
    for (std::size_t from = 0, to; from < edges_.size(); from = to) {
      int sum = 0;
      const PointId low = edges_[from].low, high = edges_[from].high;
      for (to = from; to < edges_.size() && edges_[to].low == low && edges_[to].high == high; ++to)
        sum += edges_[to].forward ? 1 : -1;
      for (; sum > 0; --sum) left_.push_back({low, high});
      for (; sum < 0; ++sum) left_.push_back({high, low});
    }
  }
  std::size_t first_from(PointId from) const {
    const auto at = std::lower_bound(left_.begin(), left_.end(), std::pair(from, PointId(0)));
    return static_cast<std::size_t>(at - left_.begin());
  }
  // The end of the next edge that leaves a point; as many leave as arrive.
  PointId take(PointId from) {
    const std::size_t first = first_from(from);
    return left_[first + taken_[first]++].second;
  }

  std::vector<Edge> edges_;
  std::vector<std::pair<PointId, PointId>> left_;
  std::vector<std::uint32_t> taken_;  // per edge that is the first to leave its point: how many
};

class FaceSplitter {
 public:
  FaceSplitter(const Kernel& kernel, const Polygons& polygons, std::size_t face)
      : kernel_(kernel), polygons_(polygons), face_(face), corners_(polygons.face_corners(face)) {
    const std::uint32_t begin = polygons.loop_begin(polygons.first_loop(face));
    for (std::uint32_t l = polygons.first_loop(face); l < polygons.face_end[face]; ++l)
      loop_ends_.push_back(polygons.loop_end[l] - begin);
  }

  std::vector<Triangle> run(bool planar, CrossingFaces crossing) {
    bool found = false;
    for (const View& view : views(kernel_.geometry(), polygons_, face_)) {
      std::vector<Triangle> triangles;
      if (!triangulate_seen(view, triangles)) {
        if (planar) break;
        continue;
      }
      found = true;
      // The first view is the best one, unless a corner hides an edge there.
      const bool whole = add_missing(triangles);
      if (triangles_.empty() || whole) triangles_ = std::move(triangles);
      if (whole || planar) break;
    }
    const bool may_refuse = planar && crossing == CrossingFaces::refuse;
    if (!found && (may_refuse || loop_ends_.size() > 1)) refuse();
    if (!found) add_missing(triangles_);
    return std::move(triangles_);
  }

 private:
  bool triangulate_seen(const View& view, std::vector<Triangle>& triangles) const {
    const FacePredicates exact(kernel_, view.axis, view.behind, corners_);
    std::vector<std::array<std::uint32_t, 3>> numbers;
    try {
      triangulate(exact, std::span<const std::uint32_t>(loop_ends_), numbers);
    } catch (const InternalError&) {  // the loops cross as seen from there
      return false;
    }
    for (const auto& t : numbers)
      triangles.push_back({corners_[t[0]], corners_[t[1]], corners_[t[2]]});
    return true;
  }

  // Where the triangles' boundary is not the face's, because a corner lies on an edge as seen from
  // there, fans fill what is between. Without any triangle, the face becomes a fan. Returns false
  // if something was missing.
  bool add_missing(std::vector<Triangle>& triangles) const {
    Boundary boundary;
    for (const Triangle& t : triangles) boundary.add(t);
    for (std::uint32_t l = polygons_.first_loop(face_); l < polygons_.face_end[face_]; ++l)
      boundary.add_reversed(polygons_.loop(l));
    const auto paths = boundary.rest();
    for (const auto& path : paths)
      for (std::size_t i = path.size() - 1; i > 1; --i)
        triangles.push_back({path[0], path[i], path[i - 1]});
    return paths.empty();
  }

  [[noreturn]] void refuse() const {
    const std::uint32_t source = polygons_.source[face_];
    throw InvalidSolid(InvalidSolid::Reason::self_intersecting,
                       "the edges of face " + std::to_string(source) +
                           " cross each other; split it into simple polygons",
                       source);
  }

  const Kernel& kernel_;
  const Polygons& polygons_;
  std::size_t face_;
  std::span<const PointId> corners_;
  std::vector<std::uint32_t> loop_ends_;
  std::vector<Triangle> triangles_;
};

}  // namespace

void split_face(const Kernel& kernel, const Polygons& polygons, std::size_t face, bool planar,
                CrossingFaces crossing, Polygons& result) {
  for (const auto& [a, b, c] : FaceSplitter(kernel, polygons, face).run(planar, crossing))
    if (a != b && b != c && c != a) result.add_triangle(a, b, c, polygons.source[face]);
}

}  // namespace sectile
