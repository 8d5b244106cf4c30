
#include <algorithm>
#include <array>
#include <string>

#include "geometry/face_predicates.h"
#include "geometry/triangulation.h"
#include "import/crossing.h"
#include "import/polygons.h"
#include "parallel/parallel.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

// The corner of a loop that comes first in lexicographic order is convex; with its neighbours it
// spans the plane.
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
  if (loop.size() <= 8) {
    for (std::size_t i = 2; i < loop.size(); ++i)
      if (std::find(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(i) - 1, loop[i]) !=
          loop.begin() + static_cast<std::ptrdiff_t>(i) - 1)
        return true;
    return false;
  }
  std::vector<PointId> sorted(loop.begin(), loop.end());
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

enum class Shape : std::uint8_t {
  whole,          ///< is a plane face
  touching,       ///< in a plane, but the outer loop visits a place twice
  bent,           ///< in no plane
  crossing,       ///< in a plane, but edges cross
  wrong_way_hole  ///< in a plane, but a hole has the orientation of the outer loop
};

class PlaneFinder {
 public:
  PlaneFinder(Polygons& polygons, Geometry& geometry, Kernel& kernel, CrossingFaces crossing)
      : polygons_(polygons),
        geometry_(geometry),
        kernel_(kernel),
        crossing_(crossing),
        shapes_(polygons.face_count(), Shape::whole) {}

  void run() {
    add_planes();
    kernel_.refresh();
    parallel::loop(parallel::Range<std::size_t>(0, shapes_.size(), 1024), [&](const auto& range) {
      for (std::size_t f = range.begin(); f < range.end(); ++f)
        if (!polygons_.is_triangle(f)) shapes_[f] = shape(f);
    });
    const auto is_whole = [](Shape shape) { return shape == Shape::whole; };
    if (std::all_of(shapes_.begin(), shapes_.end(), is_whole)) return;
    refuse_wrong_ones();
    split_faces();
    geometry_.planes.clear();
    add_planes();
    kernel_.refresh_all();
  }

 private:
  void add_planes() {
    const std::size_t count = polygons_.face_count();
    geometry_.planes.resize(count);
    parallel::loop(parallel::Range<std::size_t>(0, count, 1024), [&](const auto& range) {
      for (std::size_t f = range.begin(); f < range.end(); ++f) {
        const auto loop = polygons_.loop(polygons_.first_loop(f));
        const auto [a, b, c] =
            loop.size() == 3 ? std::array{loop[0], loop[1], loop[2]} : convex_corner(kernel_, loop);
        geometry_.planes[PlaneId(f)] = PlaneDefinition::through(a, b, c);
      }
    });
  }

  Shape shape(std::size_t f) const {
    const PlaneId plane(f);
    for (const PointId p : polygons_.face_corners(f))
      if (kernel_.side(p, plane) != Sign::zero) return Shape::bent;
    const int axis = kernel_.main_axis(plane);
    if (polygons_.face_end[f] == polygons_.first_loop(f) + 1) {
      const auto loop = polygons_.face_corners(f);
      if (visits_twice(loop)) return Shape::touching;
      const std::uint32_t end[] = {static_cast<std::uint32_t>(loop.size())};
      return edges_cross(kernel_, axis, is_behind(plane, axis), loop, end, crossing_)
                 ? Shape::crossing
                 : Shape::whole;
    }
    return shape_with_holes(f, axis);
  }

  bool is_behind(PlaneId plane, int axis) const {
    return kernel_.normal(plane, axis) == Sign::negative;
  }

  Shape shape_with_holes(std::size_t f, int axis) const {
    const auto corners = polygons_.face_corners(f);
    const bool behind = is_behind(PlaneId(f), axis);
    std::vector<std::uint32_t> ends;
    const std::uint32_t begin = polygons_.loop_begin(polygons_.first_loop(f));
    for (std::uint32_t l = polygons_.first_loop(f); l < polygons_.face_end[f]; ++l)
      ends.push_back(polygons_.loop_end[l] - begin);
    if (edges_cross(kernel_, axis, behind, corners, ends, crossing_)) return Shape::crossing;
    const FacePredicates exact(kernel_, axis, behind, corners);
    for (std::size_t l = 1; l < ends.size(); ++l)
      if (orientation(exact, ends[l - 1], ends[l]) == Sign::positive) return Shape::wrong_way_hole;
    return Shape::whole;
  }

  void refuse_wrong_ones() const {
    for (std::size_t f = 0; f < shapes_.size(); ++f) {
      const std::string face = std::to_string(polygons_.source[f]);
      if (shapes_[f] == Shape::crossing && crossing_ == CrossingFaces::refuse)
        throw InvalidSolid(
            InvalidSolid::Reason::self_intersecting,
            "the edges of face " + face + " cross each other; split it into simple polygons",
            polygons_.source[f]);
      if (shapes_[f] == Shape::wrong_way_hole)
        throw InvalidSolid(
            InvalidSolid::Reason::inconsistent,
            "a hole of face " + face + " runs the same way as its outer loop; turn it around",
            polygons_.source[f]);
    }
  }

  void split_faces() {
    std::vector<std::size_t> split;
    for (std::size_t f = 0; f < shapes_.size(); ++f)
      if (shapes_[f] != Shape::whole) split.push_back(f);
    std::vector<Polygons> pieces(split.size());
    parallel::loop(0, split.size(), [&](std::size_t i) {
      split_face(kernel_, polygons_, split[i], shapes_[split[i]] != Shape::bent, crossing_,
                 pieces[i]);
    });
    Polygons result;
    auto next = pieces.begin();
    for (std::size_t f = 0; f < polygons_.face_count(); ++f) {
      if (shapes_[f] == Shape::whole) {
        result.add_face(polygons_, f);
        continue;
      }
      for (std::size_t k = 0; k < next->face_count(); ++k) result.add_face(*next, k);
      ++next;
    }
    polygons_ = std::move(result);
    remove_flat_faces(polygons_, kernel_);
  }

  Polygons& polygons_;
  Geometry& geometry_;
  Kernel& kernel_;
  CrossingFaces crossing_;
  std::vector<Shape> shapes_;
};

}  // namespace

void find_face_planes(Polygons& polygons, Geometry& geometry, Kernel& kernel,
                      CrossingFaces crossing) {
  PlaneFinder(polygons, geometry, kernel, crossing).run();
}

}  // namespace sectile
