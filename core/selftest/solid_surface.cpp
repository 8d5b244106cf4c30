#include "selftest/solid_surface.h"

#include <algorithm>
#include <span>

#include "geometry/face_predicates.h"
#include "geometry/triangulation.h"
#include "numbers/none.h"
#include "parallel/parallel.h"
#include "sectile/errors.h"
#include "selftest/rim_sweep.h"
#include "topology/triangle.h"

namespace sectile {
namespace {

constexpr std::size_t chunk = 1024;

// A solid whose faces are triangles, all of them.
TriangleSurface surface_of_triangles(const Brep& brep) {
  TriangleSurface surface;
  const std::size_t count = brep.face_count();
  surface.corners.resize(count);
  surface.plane.resize(count);
  surface.face.resize(count);
  surface.mate.resize(count);
  parallel::loop(parallel::Range<std::size_t>(0, count, chunk), [&](const auto& range) {
    for (std::size_t f = range.begin(); f < range.end(); ++f) {
      HalfEdgeId h = brep.loop_half_edge[brep.outer_loop[FaceId(f)]];
      for (std::size_t k = 0; k < 3; ++k, h = brep.next_of(h)) {
        surface.corners[f][k] = brep.point_of(brep.from(h));
        surface.mate[f][k] = brep.face_of(Brep::twin(h)).value();
      }
      surface.plane[f] = brep.plane[FaceId(f)];
      surface.face[f] = static_cast<std::uint32_t>(f);
    }
  });
  return surface;
}

// The triangles of one face and what lies across their edges.
class FaceTriangles {
 public:
  FaceTriangles(const Brep& brep, const Kernel& kernel)
      : brep_(brep), kernel_(kernel), sweep_(kernel) {}

  struct Triangle {
    std::array<PointId, 3> corners;
    /// The half-edge on which an edge lies; if there is none, the triangle of the same face.
    std::array<HalfEdgeId, 3> half_edge;
    std::array<std::uint32_t, 3> mate{none, none, none};
    std::array<bool, 3> whole{true, true, true};  ///< the half-edge in its whole length
  };

  enum class Shape : std::uint8_t { simple, doubtful, crossing };

  /// Appends them; `mate` counts from `result`'s begin. A doubtful face's triangles may overlap.
  Shape run(FaceId face, std::vector<Triangle>& result) {
    face_ = face;
    read_loops();
    axis_ = kernel_.main_axis(brep_.plane[face]);
    behind_ = kernel_.normal(brep_.plane[face], axis_) == Sign::negative;
    const bool simple = is_convex() || winds_once();
    numbers_.clear();
    const std::size_t before = result.size();
    try {
      triangulate_in_shape(FacePredicates(kernel_, axis_, behind_, points_),
                           std::span<const std::uint32_t>(loop_ends_), numbers_);
      inner_.clear();
      for (const auto& t : numbers_) add(t, result);
      match_inner_edges(result);
    } catch (const InternalError&) {  // the loops bound no region
      if (simple) throw;
      result.resize(before);
      return Shape::crossing;
    }
    return simple ? Shape::simple : Shape::doubtful;
  }

 private:
  struct InnerEdge {
    PointId low, high;
    bool forward;
    std::uint32_t triangle, k;
  };

  void read_loops() {
    points_.clear();
    half_edges_.clear();
    next_.clear();
    loop_ends_.clear();
    for (LoopId l = brep_.outer_loop[face_]; l.valid(); l = brep_.next_loop[l]) {
      const auto begin = static_cast<std::uint32_t>(points_.size());
      for_each_in_loop(brep_, l, [&](HalfEdgeId h) {
        points_.push_back(brep_.point_of(brep_.from(h)));
        half_edges_.push_back(h);
        next_.push_back(static_cast<std::uint32_t>(points_.size()));
      });
      next_.back() = begin;
      loop_ends_.push_back(static_cast<std::uint32_t>(points_.size()));
    }
  }

  // Three corners, or four turns to the left, which make one round.
  bool is_convex() const {
    if (loop_ends_.size() > 1 || points_.size() > 4) return false;
    const Sign left = behind_ ? Sign::negative : Sign::positive;
    for (std::size_t i = 0; i < points_.size() && points_.size() == 4; ++i)
      if (kernel_.turn(points_[i], points_[(i + 1) % 4], points_[(i + 2) % 4], axis_) != left)
        return false;
    return true;
  }

  bool winds_once() {
    rim_.clear();
    for (const HalfEdgeId h : half_edges_)
      rim_.push_back({brep_.point_of(brep_.from(h)), brep_.point_of(brep_.to(h))});
    return sweep_.winds_once(rim_, axis_, behind_);
  }

  void add(const std::array<std::uint32_t, 3>& numbers, std::vector<Triangle>& result) {
    const auto number = static_cast<std::uint32_t>(result.size());
    Triangle& t = result.emplace_back();
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t from = numbers[k], to = numbers[k < 2 ? k + 1 : 0];
      t.corners[k] = points_[from];
      if (next_[from] == to) {
        t.half_edge[k] = half_edges_[from];
        continue;
      }
      const PointId p = points_[from], q = points_[to];
      inner_.push_back({std::min(p, q), std::max(p, q), p < q, number, k});
    }
  }

  void match_inner_edges(std::vector<Triangle>& result) {
    std::sort(inner_.begin(), inner_.end(), [](const InnerEdge& a, const InnerEdge& b) {
      return std::tie(a.low, a.high, a.triangle, a.k) < std::tie(b.low, b.high, b.triangle, b.k);
    });
    for (std::size_t i = 0; i < inner_.size();) {
      const InnerEdge& e = inner_[i];
      if (i + 1 < inner_.size() && inner_[i + 1].low == e.low && inner_[i + 1].high == e.high &&
          inner_[i + 1].forward != e.forward) {
        const InnerEdge& other = inner_[i + 1];
        result[e.triangle].mate[e.k] = other.triangle;
        result[other.triangle].mate[other.k] = e.triangle;
        i += 2;
        continue;
      }
      find_half_edge(result[e.triangle], e.k);
      ++i;
    }
  }

  // Part of a half-edge that a corner touches from within the face, or one whose ends have several
  // corners.
  void find_half_edge(Triangle& t, std::uint32_t k) const {
    const PointId p = t.corners[k], q = t.corners[k < 2 ? k + 1 : 0];
    for (const HalfEdgeId h : half_edges_) {
      const PointId u = brep_.point_of(brep_.from(h)), v = brep_.point_of(brep_.to(h));
      if (kernel_.turn(u, v, p, axis_) != Sign::zero || kernel_.turn(u, v, q, axis_) != Sign::zero)
        continue;
      if (order(u, v) != order(p, q) || order(u, p) == -order(u, v) || order(q, v) == -order(u, v))
        continue;
      t.half_edge[k] = h;
      t.whole[k] = p == u && q == v;
      return;
    }
    throw InternalError("the edge of a triangle is on no edge of its face");
  }
  Sign order(PointId p, PointId q) const {
    for (int axis = 0; axis < 3; ++axis)
      if (const Sign s = kernel_.compare(p, q, axis); s != Sign::zero) return s;
    return Sign::zero;
  }

  const Brep& brep_;
  const Kernel& kernel_;
  FaceId face_;
  int axis_ = 0;
  bool behind_ = false;
  RimSweep sweep_;
  std::vector<RimEdge> rim_;
  std::vector<PointId> points_;
  std::vector<HalfEdgeId> half_edges_;
  std::vector<std::uint32_t> next_, loop_ends_;
  std::vector<std::array<std::uint32_t, 3>> numbers_;
  std::vector<InnerEdge> inner_;
};

class SurfaceBuilder {
 public:
  SurfaceBuilder(const Brep& brep, const Kernel& kernel) : brep_(brep), kernel_(kernel) {}

  TriangleSurface run(std::vector<FaceId>& crossing) {
    triangulate_faces();
    note_shapes(crossing);
    number_triangles();
    std::vector<std::uint32_t> owner(brep_.half_edge_count(), none);
    parallel::loop(0, parts_.size(), [&](std::size_t i) { note_owners(i, owner); });
    parallel::loop(0, parts_.size(), [&](std::size_t i) { find_mates(i, owner); });
    return std::move(surface_);
  }

 private:
  struct Part {
    std::vector<FaceTriangles::Triangle> triangles;
    std::vector<std::uint32_t> face_end;
    std::uint32_t first = 0;  ///< number of its first triangle
  };

  void triangulate_faces() {
    const std::size_t faces = brep_.face_count();
    parts_.resize((faces + chunk - 1) / chunk);
    shapes_.resize(faces);
    parallel::loop(0, parts_.size(), [&](std::size_t i) {
      FaceTriangles triangles(brep_, kernel_);
      for (std::size_t f = i * chunk; f < std::min(faces, (i + 1) * chunk); ++f) {
        shapes_[f] = triangles.run(FaceId(f), parts_[i].triangles);
        parts_[i].face_end.push_back(static_cast<std::uint32_t>(parts_[i].triangles.size()));
      }
    });
  }

  void note_shapes(std::vector<FaceId>& crossing) {
    for (std::size_t f = 0; f < shapes_.size(); ++f) {
      if (shapes_[f] == FaceTriangles::Shape::crossing) crossing.push_back(FaceId(f));
      if (shapes_[f] != FaceTriangles::Shape::doubtful) continue;
      if (surface_.doubtful.empty()) surface_.doubtful.assign(shapes_.size(), 0);
      surface_.doubtful[f] = 1;
    }
  }

  void number_triangles() {
    std::uint32_t count = 0;
    for (Part& part : parts_) {
      part.first = count;
      count += static_cast<std::uint32_t>(part.triangles.size());
    }
    surface_.corners.resize(count);
    surface_.plane.resize(count);
    surface_.face.resize(count);
    surface_.mate.resize(count);
    first_of_face_.resize(brep_.face_count());
  }

  void note_owners(std::size_t i, std::vector<std::uint32_t>& owner) {
    const Part& part = parts_[i];
    std::uint32_t t = 0;
    for (std::size_t k = 0; k < part.face_end.size(); ++k) {
      const std::size_t f = i * chunk + k;
      first_of_face_[f] = part.first + t;
      for (; t < part.face_end[k]; ++t) {
        surface_.corners[part.first + t] = part.triangles[t].corners;
        surface_.plane[part.first + t] = brep_.plane[FaceId(f)];
        surface_.face[part.first + t] = static_cast<std::uint32_t>(f);
        for (std::size_t e = 0; e < 3; ++e) {
          const HalfEdgeId h = part.triangles[t].half_edge[e];
          if (h.valid() && part.triangles[t].whole[e]) owner[h.value()] = part.first + t;
        }
      }
    }
  }

  void find_mates(std::size_t i, const std::vector<std::uint32_t>& owner) {
    const Part& part = parts_[i];
    for (std::uint32_t t = 0; t < part.triangles.size(); ++t)
      for (std::size_t e = 0; e < 3; ++e) {
        const FaceTriangles::Triangle& triangle = part.triangles[t];
        std::uint32_t& mate = surface_.mate[part.first + t][e];
        const HalfEdgeId h = triangle.half_edge[e];
        if (!h.valid()) {
          mate = part.first + triangle.mate[e];
          continue;
        }
        mate = triangle.whole[e] ? owner[Brep::twin(h).value()] : none;
        if (mate == none)
          mate = first_of_face_[brep_.face_of(Brep::twin(h)).value()] | TriangleSurface::partial;
      }
  }

  const Brep& brep_;
  const Kernel& kernel_;
  std::vector<Part> parts_;
  std::vector<FaceTriangles::Shape> shapes_;
  std::vector<std::uint32_t> first_of_face_;
  TriangleSurface surface_;
};

}  // namespace

TriangleSurface surface_of(const Brep& brep, const Kernel& kernel, std::vector<FaceId>& crossing) {
  for (std::size_t f = 0; f < brep.face_count(); ++f)
    if (!is_triangle(brep, FaceId(f))) return SurfaceBuilder(brep, kernel).run(crossing);
  return surface_of_triangles(brep);
}

}  // namespace sectile
