// A joined face is a set of faces that hang together over edges between coplanar faces:
//
//     o-------o-------o           o---------------o     Edges between two faces of one set go, and
//     |     / | \     |           |               |     vertices that lose all their edges. What
//     |   /   o   \   |    ==>    |               |     is left of the others' loops, followed
//     | /   /   \   \ |           |               |     from corner to corner of the set, are its
//     o---o-------o---o           o---------------o     loops. Vertices between just two edges of
//                                                       one line go, too.
//
// Where several vertices are at one point, the boundary touches itself, and what is tested there
// looks at vertices: faces with such a corner stay as they are. So no edge that stays has the same
// face on both sides.
#include "import/join_flat_faces.h"

#include <algorithm>

#include "geometry/face_predicates.h"
#include "geometry/triangulation.h"
#include "numbers/disjoint_sets.h"
#include "numbers/none.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

// The sets of faces that are joined.
class FlatSets {
 public:
  FlatSets(const Brep& brep, std::span<const std::uint32_t> groups)
      : brep_(brep), groups_(groups), sets_(brep.face_count()) {}

  /// Returns whether any faces are joined.
  bool find_sets(const std::vector<std::uint8_t>& is_shared) {
    std::vector<std::uint8_t> stays(brep_.face_count(), 0);
    for (const HalfEdgeId h : brep_.half_edges())
      if (is_shared[brep_.from(h).value()]) stays[brep_.face_of(h).value()] = 1;
    bool any = false;
    for (const EdgeId e : brep_.edges()) {
      if (!brep_.edge_plane[e].valid()) continue;
      const FaceId f = brep_.face_of(Brep::half_edge(e)), g = brep_.face_of(Brep::half_edge(e, 1));
      if (stays[f.value()] || stays[g.value()] || group(f) != group(g)) continue;
      any = any || f != g;
      sets_.unite(f.value(), g.value());
    }
    if (any) numbers_ = std::move(sets_).numbered();
    return any;
  }

  std::size_t count() const { return numbers_.count; }
  /// The set of a face: in the order of their first faces.
  FaceId operator[](FaceId f) const { return FaceId(numbers_.of[f.value()]); }

 private:
  std::uint32_t group(FaceId f) const {
    return groups_.empty() ? 0 : groups_[brep_.source[f].face];
  }

  const Brep& brep_;
  std::span<const std::uint32_t> groups_;
  DisjointSets sets_;
  DisjointSets::Numbered numbers_;
};

// Copies the points and planes of an import that are asked for.
class GeometryPicker {
 public:
  GeometryPicker(const Geometry& from, Geometry& to)
      : from_(from), to_(to), points_(from.positions.size()), planes_(from.planes.size()) {}

  PointId point(PointId p) {
    PointId& known = points_[p.value()];
    if (!known.valid()) known = to_.add_point(from_.position(p));
    return known;
  }
  PlaneId plane(PlaneId s) {
    PlaneId& known = planes_[s.value()];
    if (known.valid()) return known;
    PlaneDefinition how = from_.definition(s);
    how.a = point(PointId(how.a)).value();
    how.b = point(PointId(how.b)).value();
    if (how.kind() == PlaneDefinition::Kind::three_points) how.c = point(PointId(how.c)).value();
    return known = to_.add_plane(how);
  }

 private:
  const Geometry& from_;
  Geometry& to_;
  std::vector<PointId> points_;
  std::vector<PlaneId> planes_;
};

class Joiner {
 public:
  Joiner(const Brep& brep, const Geometry& geometry, const Kernel& kernel,
         std::span<const std::uint32_t> groups)
      : old_(brep),
        geometry_(geometry),
        kernel_(kernel),
        sets_(brep, groups),
        picker_(geometry, made_.geometry),
        new_(made_.brep) {}

  JoinedFaces run() {
    find_shared_vertices();
    if (!sets_.find_sets(is_shared_)) return {};
    find_straight_vertices();
    add_edges();
    add_vertices();
    add_faces();
    add_loops();
    add_edge_planes();
    made_.as_read = faces_as_read();
    return std::move(made_);
  }

 private:
  // Several vertices at one point.
  void find_shared_vertices() {
    find_vertices_at_rest();
    std::vector<std::uint8_t> seen(geometry_.positions.size(), 0);
    for (const VertexId v : old_.vertices())
      if (!is_at_rest_[v.value()]) {
        std::uint8_t& times = seen[old_.point_of(v).value()];
        times = static_cast<std::uint8_t>(std::min(times + 1, 2));
      }
    is_shared_.resize(old_.vertex_count());
    for (const VertexId v : old_.vertices())
      is_shared_[v.value()] = seen[old_.point_of(v).value()] > 1;
  }

  // Around which there are faces that are not in this part of the boundary.
  void find_vertices_at_rest() {
    is_at_rest_.assign(old_.vertex_count(), 0);
    if (old_.kind.empty()) return;
    for (const HalfEdgeId h : old_.half_edges())
      if (old_.kind_of(old_.face_of(h)) == FaceKind::rest)
        is_at_rest_[old_.from(h).value()] = is_at_rest_[old_.to(h).value()] = 1;
  }

  FaceId set_of(HalfEdgeId h) const { return sets_[old_.face_of(h)]; }
  bool stays(HalfEdgeId h) const { return set_of(h) != set_of(Brep::twin(h)); }
  bool is_flat(HalfEdgeId h) const { return old_.extra_plane(Brep::edge_of(h)).valid(); }

  // The next and the last half-edge that stay, on the way round the set.
  HalfEdgeId next_of(HalfEdgeId h) const {
    for (h = old_.next_of(h); !stays(h);) h = old_.next_of(Brep::twin(h));
    return h;
  }
  HalfEdgeId prev_of(HalfEdgeId h) const {
    for (h = old_.prev_of(h); !stays(h);) h = old_.prev_of(Brep::twin(h));
    return h;
  }

  // Between two edges in the line of the same two planes, where an edge has gone.
  void find_straight_vertices() {
    is_straight_.resize(old_.vertex_count());
    for (const VertexId v : old_.vertices()) {
      if (is_shared_[v.value()] || is_at_rest_[v.value()]) continue;
      std::size_t left = 0, gone = 0;
      bool flat = false;
      for_each_around(old_, old_.vertex_half_edge[v], [&](HalfEdgeId h) {
        (stays(h) ? left : gone) += 1;
        flat = flat || (stays(h) && is_flat(h));
      });
      is_straight_[v.value()] = left == 2 && gone > 0 && !flat;
    }
  }
  bool starts_at_corner(HalfEdgeId h) const { return !is_straight_[old_.from(h).value()]; }

  void loses_corner(HalfEdgeId h) {
    for (const FaceId set : {set_of(h), set_of(Brep::twin(h))}) has_changed_[set.value()] = 1;
  }

  // A new edge is a path of old ones over straight vertices.
  void add_edges() {
    number_.resize(old_.half_edge_count());
    has_changed_.assign(sets_.count(), 0);
    for (std::uint32_t i = 0; i < number_.size(); i += 2) {
      if (number_[i].valid() || !stays(HalfEdgeId(i))) continue;
      HalfEdgeId first{i};
      while (!starts_at_corner(first)) {
        first = prev_of(first);
        if (first.value() == i) throw InternalError("a straight line comes back to its beginning");
      }
      const HalfEdgeId forward(first_.size()), back = Brep::twin(forward);
      HalfEdgeId last = first;
      for (HalfEdgeId h = first;; h = next_of(h)) {
        if (h != first && starts_at_corner(h)) break;
        if (h != first) loses_corner(h);
        number_[h.value()] = forward;
        number_[Brep::twin(h).value()] = back;
        last = h;
      }
      first_.insert(first_.end(), {first, Brep::twin(last)});
    }
    const std::size_t count = first_.size();
    new_.resize_half_edges(count);
    for (std::uint32_t i = 0; i < count; ++i) {
      const HalfEdgeId last = Brep::twin(first_[i ^ 1u]), after = number_[next_of(last).value()];
      new_.next[HalfEdgeId(i)] = after;
      new_.prev[after] = HalfEdgeId(i);
    }
  }

  void add_vertices() {
    std::vector<VertexId> number(old_.vertex_count());
    for (std::uint32_t i = 0; i < first_.size(); ++i) {
      const VertexId v = old_.from(first_[i]);
      if (!number[v.value()].valid()) {
        number[v.value()] = VertexId(new_.vertex_count());
        new_.point.add(picker_.point(old_.point_of(v)));
        new_.vertex_half_edge.add(HalfEdgeId(i));
      }
      new_.origin[HalfEdgeId(i)] = number[v.value()];
    }
  }

  // The plane is that of the largest part: tests in doubles decide more there.
  void add_faces() {
    Table<FaceId, double> size(sets_.count(), -1);
    new_.outer_loop.resize(sets_.count());
    new_.source.resize(sets_.count());
    Table<FaceId, PlaneId> plane(sets_.count());
    parts_.assign(sets_.count(), 0);
    if (!old_.kind.empty()) new_.kind.resize(sets_.count());
    for (const FaceId f : old_.faces()) {
      const FaceId set = sets_[f];
      if (!old_.kind.empty()) new_.kind[set] = old_.kind[f];
      if (old_.kind_of(f) == FaceKind::rest) continue;
      const FaceSource source = old_.source[f];
      new_.source[set] = parts_[set.value()]++ == 0 ? source : std::min(new_.source[set], source);
      const double here = size_of(old_.plane[f]);
      if (!(here <= size[set])) {  // also where doubles end
        size[set] = here;
        plane[set] = old_.plane[f];
      }
    }
    for (const PlaneId s : plane) new_.plane.add(s.valid() ? picker_.plane(s) : s);
  }
  double size_of(PlaneId s) const {
    const PlaneDefinition& how = geometry_.definition(s);
    const Vec3 &a = geometry_.position(PointId(how.a)), &b = geometry_.position(PointId(how.b)),
               &c = geometry_.position(PointId(how.c));
    const double u[3] = {b.x - a.x, b.y - a.y, b.z - a.z}, v[3] = {c.x - a.x, c.y - a.y, c.z - a.z};
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
      const double n = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
      sum += n * n;
    }
    return sum;
  }

  void add_loops() {
    std::vector<std::vector<LoopId>> several;  // the loops of faces with more than one
    std::vector<std::uint32_t> place(sets_.count(), none);
    for (std::uint32_t i = 0; i < first_.size(); ++i) {
      if (new_.loop[HalfEdgeId(i)].valid()) continue;
      const FaceId face = set_of(first_[i]);
      const LoopId loop = new_.add_loop(face, HalfEdgeId(i));
      for_each_in_loop(new_, loop, [&](HalfEdgeId h) { new_.loop[h] = loop; });
      LoopId& outer = new_.outer_loop[face];
      if (!outer.valid()) {
        outer = loop;
        continue;
      }
      std::uint32_t& at = place[face.value()];
      if (at == none) {
        at = static_cast<std::uint32_t>(several.size());
        several.push_back({outer});
      }
      several[at].push_back(loop);
    }
    for (const auto& loops : several) chain(loops);
  }

  // The outer loop first.
  void chain(const std::vector<LoopId>& loops) {
    const FaceId face = new_.loop_face[loops.front()];
    LoopId outer;
    for (const LoopId l : loops) {
      if (!is_outer(l)) continue;
      if (outer.valid()) throw InternalError("a joined face has two outer loops");
      outer = l;
    }
    if (!outer.valid()) throw InternalError("a joined face has no outer loop");
    LoopId last = new_.outer_loop[face] = outer;
    for (const LoopId l : loops)
      if (l != outer) last = new_.next_loop[last] = l;
  }
  bool is_outer(LoopId loop) const {
    std::vector<PointId> corners;
    for_each_in_loop(new_, loop, [&](HalfEdgeId h) {
      corners.push_back(old_.point_of(old_.from(first_[h.value()])));
    });
    const HalfEdgeId member = first_[new_.loop_half_edge[loop].value()];
    const PlaneId plane = old_.plane_of(member);
    const int axis = kernel_.main_axis(plane);
    const FacePredicates exact(kernel_, axis, kernel_.normal(plane, axis) == Sign::negative,
                               corners);
    return orientation(exact, 0, static_cast<std::uint32_t>(corners.size())) == Sign::positive;
  }

  void add_edge_planes() {
    for (std::uint32_t i = 0; i < first_.size(); i += 2) {
      const PlaneId plane = old_.edge_plane[Brep::edge_of(first_[i])];
      if (!plane.valid()) continue;
      if (new_.edge_plane.empty()) new_.edge_plane.resize(new_.edge_count());
      new_.edge_plane[EdgeId(i / 2)] = picker_.plane(plane);
    }
  }

  // A face of the input may have been split and its parts been joined with different neighbours, or
  // not at all: then all that is named by it is kept.
  std::shared_ptr<const FacesAsRead> faces_as_read() const {
    std::vector<FaceSource> names;
    for (std::size_t set = 0; set < parts_.size(); ++set)
      if (parts_[set] > 1 || has_changed_[set]) names.push_back(new_.source[FaceId(set)]);
    std::sort(names.begin(), names.end());
    auto read = std::make_shared<FacesAsRead>();
    GeometryPicker picker(geometry_, read->geometry);
    for (const FaceId f : old_.faces()) {
      const FaceSource name = new_.source[sets_[f]];
      if (old_.kind_of(f) == FaceKind::real && std::binary_search(names.begin(), names.end(), name))
        add_triangles(f, name.face, picker, read->triangles);
    }
    std::stable_sort(read->triangles.begin(), read->triangles.end(),
                     [](const auto& s, const auto& t) {
                       return s.joined != t.joined ? s.joined < t.joined : s.source < t.source;
                     });
    return read;
  }
  void add_triangles(FaceId f, std::uint32_t name, GeometryPicker& picker,
                     std::vector<FacesAsRead::Triangle>& to) const {
    std::vector<PointId> corners;
    std::vector<std::uint32_t> loop_ends;
    for (LoopId l = old_.outer_loop[f]; l.valid(); l = old_.next_loop[l]) {
      for_each_in_loop(old_, l,
                       [&](HalfEdgeId h) { corners.push_back(old_.point_of(old_.from(h))); });
      loop_ends.push_back(static_cast<std::uint32_t>(corners.size()));
    }
    const PlaneId plane = old_.plane[f];
    const int axis = kernel_.main_axis(plane);
    const FacePredicates exact(kernel_, axis, kernel_.normal(plane, axis) == Sign::negative,
                               corners);
    std::vector<std::array<std::uint32_t, 3>> triangles;
    triangulate(exact, std::span<const std::uint32_t>(loop_ends), triangles);
    for (const auto& t : triangles)
      to.push_back({name,
                    old_.source[f].face,
                    {picker.point(corners[t[0]]), picker.point(corners[t[1]]),
                     picker.point(corners[t[2]])}});
  }

  const Brep& old_;
  const Geometry& geometry_;
  const Kernel& kernel_;
  FlatSets sets_;
  JoinedFaces made_;
  GeometryPicker picker_;
  Brep& new_;
  std::vector<std::uint8_t> is_shared_, is_at_rest_, is_straight_;  // per old vertex
  std::vector<HalfEdgeId> number_;         // per old half-edge: the new one
  std::vector<HalfEdgeId> first_;          // per new half-edge: the first old one of its path
  std::vector<std::uint32_t> parts_;       // per new face: the old ones in it
  std::vector<std::uint8_t> has_changed_;  // per new face: corners in its edges are gone
};

}  // namespace

JoinedFaces join_flat_faces(const Brep& brep, const Geometry& geometry, const Kernel& kernel,
                            std::span<const std::uint32_t> groups) {
  if (brep.edge_plane.empty()) return {};
  return Joiner(brep, geometry, kernel, groups).run();
}

std::shared_ptr<SolidData> with_flat_faces_joined(std::shared_ptr<SolidData> data,
                                                  const Kernel& kernel,
                                                  std::span<const std::uint32_t> groups) {
  JoinedFaces joined = join_flat_faces(data->brep(), data->geometry(), kernel, groups);
  if (!joined.as_read) return data;
  auto made = std::make_shared<SolidData>();
  made->brep() = std::move(joined.brep);
  made->geometry() = std::move(joined.geometry);
  made->as_read = std::move(joined.as_read);
  made->origin = data->origin;
  return made;
}

}  // namespace sectile
