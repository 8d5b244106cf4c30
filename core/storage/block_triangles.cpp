#include "storage/block_triangles.h"

#include <algorithm>
#include <utility>

#include "geometry/face_predicates.h"
#include "geometry/kernel.h"
#include "geometry/seen_loop.h"
#include "geometry/triangulation.h"
#include "numbers/threshold.h"
#include "parallel/parallel.h"
#include "sectile/errors.h"
#include "storage/block_elements.h"
#include "storage/vertex_sets.h"
#include "topology/triangle.h"

namespace sectile {
namespace {

// What the faces of one block that are no triangles were cut into.
struct CutFaces {
  std::vector<std::array<VertexId, 3>> triangles;  ///< as they run in the solid
  std::vector<std::uint32_t> face_end;             ///< per face that is no triangle
};

// The sides of a face of few corners: a row of bits for each corner.
class SideMatrix {
 public:
  static constexpr std::uint32_t most_corners = threshold(32, 4);

  /// False if it was there.
  bool add(std::uint32_t from, std::uint32_t to) {
    const std::uint32_t bit = 1u << to;
    const bool is_new = (to_[from] & bit) == 0;
    to_[from] |= bit;
    from_[to] |= 1u << from;
    return is_new;
  }
  /// Is each there the other way, too?
  bool are_matched(std::uint32_t corners) const {
    return std::equal(to_.begin(), to_.begin() + corners, from_.begin());
  }

 private:
  std::array<std::uint32_t, most_corners> to_ = {}, from_ = {};
};

class FaceCutter {
 public:
  FaceCutter(const Slot& slot, CutFaces& result)
      : slot_(slot), brep_(slot.block->brep()), result_(result) {}

  /// False if no triangles between all corners, and with no others, make up a face.
  bool run() {
    std::vector<FaceId> faces;
    std::vector<PlaneId> planes;
    for (std::uint32_t f = 0; f < brep_.face_count(); ++f) {
      if (is_triangle(brep_, FaceId(f))) continue;
      faces.push_back(FaceId(f));
      planes.push_back(brep_.plane[FaceId(f)]);
    }
    if (faces.empty()) return true;
    const Kernel kernel(slot_.block->geometry(), planes);
    return std::all_of(faces.begin(), faces.end(), [&](FaceId f) { return cut(f, kernel); });
  }

 private:
  struct Side {
    std::uint32_t low, high;
    bool forward;
    auto operator<=>(const Side&) const = default;
  };

  bool cut(FaceId f, const Kernel& kernel) {
    points_.clear();
    vertices_.clear();
    ends_.clear();
    for (LoopId l = brep_.outer_loop[f]; l.valid(); l = brep_.next_loop[l]) {
      for_each_in_loop(brep_, l, [&](HalfEdgeId h) {
        vertices_.push_back(brep_.from(h));
        points_.push_back(brep_.point_of(brep_.from(h)));
      });
      ends_.push_back(static_cast<std::uint32_t>(points_.size()));
    }
    const PlaneId plane = brep_.plane[f];
    const int axis = kernel.main_axis(plane);
    const bool behind = kernel.normal(plane, axis) == Sign::negative;
    if (!cut_as_seen(axis, behind) && !cut_exactly(FacePredicates(kernel, axis, behind, points_)))
      return false;
    for (const auto& t : numbers_)
      result_.triangles.push_back({vertices_[t[0]], vertices_[t[slot_.turned ? 2 : 1]],
                                   vertices_[t[slot_.turned ? 1 : 2]]});
    result_.face_end.push_back(static_cast<std::uint32_t>(result_.triangles.size()));
    return true;
  }

  // What is left after each ear is a loop, so all sides are matched.
  bool cut_as_seen(int axis, bool behind) {
    numbers_.clear();
    if (ends_.size() != 1 || ends_[0] > SeenLoop::most_corners) return false;
    const Geometry& geometry = slot_.block->geometry();
    SeenLoop loop(axis, behind);
    for (const PointId p : points_) loop.add(geometry.position(p));
    return EarClipping(loop, ends_[0]).run(numbers_) &&
           !any_sliver(loop, std::span(std::as_const(numbers_)));
  }
  bool cut_exactly(const FacePredicates& exact) {
    numbers_.clear();
    try {
      triangulate_in_shape(exact, std::span<const std::uint32_t>(ends_), numbers_);
    } catch (const InternalError&) {  // the loops bound no simple region
      return false;
    }
    return all_matched();
  }

  // Each side of a triangle once the other way, on another triangle or, turned, on the border.
  bool all_matched() {
    if (ends_.size() == 1 && ends_[0] <= SideMatrix::most_corners) {
      SideMatrix sides;
      bool once = true;
      for_each_side([&](std::uint32_t from, std::uint32_t to) { once &= sides.add(from, to); });
      return once && sides.are_matched(ends_[0]);
    }
    sides_.clear();
    for_each_side([&](std::uint32_t from, std::uint32_t to) {
      sides_.push_back({std::min(from, to), std::max(from, to), from < to});
    });
    std::sort(sides_.begin(), sides_.end());
    if (sides_.size() % 2 != 0) return false;
    for (std::size_t i = 0; i < sides_.size(); i += 2) {
      const Side &a = sides_[i], &b = sides_[i + 1];
      if (a.low != b.low || a.high != b.high || a.forward == b.forward) return false;
      if (i > 0 && sides_[i - 1].low == a.low && sides_[i - 1].high == a.high) return false;
    }
    return true;
  }
  template <class Visit>
  void for_each_side(const Visit& visit) const {
    for (std::uint32_t begin = 0; const std::uint32_t end : ends_) {
      for (std::uint32_t i = begin; i < end; ++i) visit(i + 1 < end ? i + 1 : begin, i);
      begin = end;
    }
    for (const auto& t : numbers_)
      for (std::size_t k = 0; k < 3; ++k) visit(t[k], t[k < 2 ? k + 1 : 0]);
  }

  const Slot& slot_;
  const Brep& brep_;
  CutFaces& result_;
  std::vector<PointId> points_;
  std::vector<VertexId> vertices_;
  std::vector<std::uint32_t> ends_;
  std::vector<Side> sides_;
  std::vector<std::array<std::uint32_t, 3>> numbers_;
};

class TriangleCollector {
 public:
  explicit TriangleCollector(const SolidData& data) : data_(data), slots_(data.slots()) {}

  std::optional<BlockTriangles> run() {
    if (data_.touches_itself()) return {};
    bool cut = false;
    std::optional<VertexSets> vertices;
    parallel::invoke([&] { cut = cut_polygons(); }, [&] { vertices.emplace(data_); });
    if (!cut) return {};
    count();
    parallel::invoke([&] { make_room(); }, [&] { number_vertices(*vertices); });
    result_.first_vertex = std::move(vertices->number.first);
    parallel::loop(0, slots_.size(), [&](std::size_t s) {
      if (!slots_[s].empty()) write(static_cast<std::uint32_t>(s));
    });
    return std::move(result_);
  }

 private:
  bool cut_polygons() {
    polygons_.resize(slots_.size());
    std::vector<std::uint8_t> whole(slots_.size(), 1);
    parallel::loop(0, slots_.size(), [&](std::size_t s) {
      if (slots_[s].empty() || BlockElements(*slots_[s].block).compact()) return;
      whole[s] = FaceCutter(slots_[s], polygons_[s]).run();
    });
    return std::find(whole.begin(), whole.end(), 0) == whole.end();
  }

  void count() {
    std::uint32_t triangles = 0;
    for (std::size_t s = 0; s < slots_.size(); ++s) {
      result_.first_triangle.push_back(triangles);
      if (slots_[s].empty()) continue;
      triangles +=
          static_cast<std::uint32_t>(slots_[s].block->face_count() - polygons_[s].face_end.size() +
                                     polygons_[s].triangles.size());
      for (std::size_t i = polygons_[s].triangles.size(); i > 0; --i)
        result_.cut.push_back(triangles - static_cast<std::uint32_t>(i));
    }
    result_.first_triangle.push_back(triangles);
  }

  void make_room() {
    const std::size_t triangles = result_.first_triangle.back();
    parallel::invoke([&] { result_.indices.resize(3 * triangles); },
                     [&] { result_.source.resize(triangles); });
  }

  // The first block that has a vertex gives it its number.
  void number_vertices(const VertexSets& vertices) {
    const std::vector<std::uint32_t>& first = vertices.number.first;
    result_.number.resize(vertices.number.count);
    result_.first_own.resize(slots_.size());
    parallel::loop(0, slots_.size(), [&](std::size_t s) {
      std::uint32_t own = 0;
      for (std::uint32_t v = first[s]; v < first[s + 1]; ++v)
        own += vertices.sets.is_first(v) ? 1 : 0;
      result_.first_own[s] = own;
    });
    for (std::uint32_t& own : result_.first_own)
      result_.vertex_count += std::exchange(own, result_.vertex_count);
    parallel::loop(0, slots_.size(), [&](std::size_t s) {
      std::uint32_t next = result_.first_own[s];
      for (std::uint32_t v = first[s]; v < first[s + 1]; ++v)
        if (vertices.sets.is_first(v)) result_.number[v] = next++;
    });
    parallel::loop(0, slots_.size(), [&](std::size_t s) {
      for (std::uint32_t v = first[s]; v < first[s + 1]; ++v)
        if (!vertices.sets.is_first(v)) result_.number[v] = result_.number[vertices.sets.first(v)];
    });
  }

  // Triangles first, then what other faces were cut into.
  void write(std::uint32_t s) {
    const BlockElements elements(*slots_[s].block);
    if (const CompactTriangles* compact = elements.compact())
      write(s, *compact);
    else
      write_structure(s);
  }

  void write(std::uint32_t s, const CompactTriangles& compact) {
    const std::uint32_t* const number = result_.number.data() + result_.first_vertex[s];
    const std::size_t first = slots_[s].turned ? 1 : 0, second = 1 - first;
    std::uint32_t* index = result_.indices.data() + 3 * std::size_t(result_.first_triangle[s]);
    FaceSource* source = result_.source.data() + result_.first_triangle[s];
    for (const auto& t : compact.triangles) {
      *index++ = number[t.vertex[first]];
      *index++ = number[t.vertex[second]];
      *index++ = number[t.vertex[2]];
      *source++ = {compact.origin, t.source};
    }
  }

  void write_structure(std::uint32_t s) {
    const Slot& slot = slots_[s];
    const Brep& brep = slot.block->brep();
    std::uint32_t t = result_.first_triangle[s];
    const auto add = [&](const std::array<VertexId, 3>& corners, FaceSource source) {
      for (std::size_t k = 0; k < 3; ++k)
        result_.indices[3 * std::size_t(t) + k] = result_.vertex(s, corners[k]);
      result_.source[t++] = source;
    };
    const CutFaces& polygons = polygons_[s];
    std::vector<std::uint32_t> others;
    for (std::uint32_t f = 0; f < brep.face_count(); ++f) {
      if (!is_triangle(brep, FaceId(f))) {
        others.push_back(f);
        continue;
      }
      const HalfEdgeId a = brep.loop_half_edge[brep.outer_loop[FaceId(f)]], b = slot.next_of(a),
                       c = slot.next_of(b);
      add({slot.from(a), slot.from(b), slot.from(c)}, brep.source[FaceId(f)]);
    }
    std::uint32_t i = 0;
    for (std::size_t k = 0; k < others.size(); ++k)
      for (; i < polygons.face_end[k]; ++i)
        add(polygons.triangles[i], brep.source[FaceId(others[k])]);
  }

  const SolidData& data_;
  std::span<const Slot> slots_;
  std::vector<CutFaces> polygons_;  // per slot
  BlockTriangles result_;
};

}  // namespace

std::optional<BlockTriangles> block_triangles(const SolidData& data) {
  return TriangleCollector(data).run();
}

}  // namespace sectile
