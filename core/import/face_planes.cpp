#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/triangulation.h"
#include "import/face_predicates.h"
#include "import/polygons.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

// The corner of a loop that comes first in lexicographic order is convex; with its neighbours it
// spans the plane, unless the loop turns back on itself there.
std::array<PointId, 3> convex_corner(const Kernel& kernel, std::span<const PointId> loop) {
  std::size_t least = 0;
  for (std::size_t i = 1; i < loop.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const Sign s = kernel.compare(loop[i], loop[least], axis);
      if (s == Sign::zero) continue;
      if (s == Sign::positive) least = i;
      break;
    }
  }
  const std::size_t n = loop.size();
  return {loop[least], loop[least + 1 < n ? least + 1 : 0], loop[least > 0 ? least - 1 : n - 1]};
}

bool visits_twice(std::span<const PointId> loop) {
  std::vector<PointId> sorted(loop.begin(), loop.end());
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

// The axis along which the polygon shows its largest area, and whether it is seen from behind.
std::pair<int, bool> view(const Geometry& g, std::span<const PointId> loop) {
  double n[3] = {0, 0, 0};
  const Vec3 o = g.position(loop[0]);
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    const Vec3 &p = g.position(loop[i]), &q = g.position(loop[i + 1]);
    const double u[3] = {p.x - o.x, p.y - o.y, p.z - o.z}, v[3] = {q.x - o.x, q.y - o.y, q.z - o.z};
    for (int k = 0; k < 3; ++k)
      n[k] += u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
  }
  int axis = 0;
  for (int k = 1; k < 3; ++k)
    if (std::abs(n[k]) > std::abs(n[axis])) axis = k;
  return {axis, n[axis] < 0};
}

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

// Any triangulation keeps the surface closed; one of the projection also keeps it from folding.
Triangles split(const Geometry& g, const Kernel& kernel, std::span<const PointId> loop) {
  Triangles triangles;
  const auto [axis, behind] = view(g, loop);
  const FacePredicates exact(kernel, axis, behind, loop);
  const std::uint32_t end[] = {static_cast<std::uint32_t>(loop.size())};
  try {
    triangulate(exact, std::span<const std::uint32_t>(end), triangles);
    return triangles;
  } catch (const InternalError&) {  // the projection crosses itself
    triangles.clear();
  }
  for (std::uint32_t i = 1; i + 1 < loop.size(); ++i) triangles.push_back({0, i, i + 1});
  return triangles;
}

enum class Shape : std::uint8_t { plane, split };

class PlaneFinder {
 public:
  PlaneFinder(Polygons& polygons, Geometry& geometry, Kernel& kernel)
      : polygons_(polygons),
        geometry_(geometry),
        kernel_(kernel),
        shapes_(polygons.face_count(), Shape::plane) {}

  void run() {
    add_planes();
    kernel_.refresh();
    const auto body = [&](const tbb::blocked_range<std::size_t>& range) {
      for (std::size_t f = range.begin(); f < range.end(); ++f)
        if (!is_planar(f)) shapes_[f] = Shape::split;
    };
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, shapes_.size(), 1024), body);
    if (std::find(shapes_.begin(), shapes_.end(), Shape::split) == shapes_.end()) return;
    split_faces();
    geometry_.planes.clear();
    add_planes();
    kernel_.refresh_all();
  }

 private:
  void add_planes() {
    const std::size_t count = polygons_.face_count();
    geometry_.planes.resize(count);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1024), [&](const auto& range) {
      for (std::size_t f = range.begin(); f < range.end(); ++f) {
        const auto loop = polygons_.loop(polygons_.first_loop(f));
        const auto [a, b, c] =
            loop.size() == 3 ? std::array{loop[0], loop[1], loop[2]} : convex_corner(kernel_, loop);
        geometry_.planes[f] = PlaneDefinition::through(a, b, c);
      }
    });
  }

  bool is_planar(std::size_t f) const {
    const PlaneId plane(f);
    for (std::uint32_t l = polygons_.first_loop(f); l < polygons_.face_end[f]; ++l) {
      const auto loop = polygons_.loop(l);
      if (loop.size() == 3 && l == polygons_.first_loop(f)) continue;
      if (visits_twice(loop)) return false;
      for (const PointId p : loop)
        if (kernel_.side(p, plane) != Sign::zero) return false;
    }
    const PlaneDefinition& how = geometry_.definition(plane);
    return polygons_.loop(polygons_.first_loop(f)).size() == 3 ||
           !collinear(kernel_, PointId(how.a), PointId(how.b), PointId(how.c));
  }

  void split_faces() {
    Polygons result;
    for (std::size_t f = 0; f < polygons_.face_count(); ++f) {
      const std::uint32_t first = polygons_.first_loop(f), end = polygons_.face_end[f];
      if (shapes_[f] == Shape::plane) {
        for (std::uint32_t l = first; l < end; ++l) result.add_loop(polygons_.loop(l));
        result.end_face(polygons_.source[f]);
        continue;
      }
      if (end - first > 1)
        throw InvalidSolid(InvalidSolid::Reason::malformed,
                           "face " + std::to_string(polygons_.source[f]) +
                               " has holes but is not planar; split it into planar faces",
                           polygons_.source[f]);
      const auto loop = polygons_.loop(first);
      for (const auto& t : split(geometry_, kernel_, loop)) {
        const PointId corners[] = {loop[t[0]], loop[t[1]], loop[t[2]]};
        if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
          continue;
        result.add_loop(corners);
        result.end_face(polygons_.source[f]);
      }
    }
    polygons_ = std::move(result);
    remove_flat_faces(polygons_, kernel_);
  }

  Polygons& polygons_;
  Geometry& geometry_;
  Kernel& kernel_;
  std::vector<Shape> shapes_;
};

}  // namespace

void find_face_planes(Polygons& polygons, Geometry& geometry, Kernel& kernel) {
  PlaneFinder(polygons, geometry, kernel).run();
}

}  // namespace sectile
