#include "boolean/patch.h"

#include "geometry/kernel.h"
#include "search/id_map.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

constexpr std::size_t many_corners = 24;

// Copies points and planes from a solid's tables to the workspace's, each once.
class GeometryLoader {
 public:
  GeometryLoader(const Geometry& from, Geometry& to, std::size_t expected)
      : from_(from), to_(to), points_(expected), planes_(expected) {}

  PointId point(PointId p) {
    if (!p.valid()) return p;
    const std::uint32_t known = points_[p.value()];
    if (known != IdMap::none) return PointId(known);
    PointId made;
    if (from_.is_explicit(p)) {
      made = to_.add_point(from_.position(p));
    } else {
      const Construction& how = from_.construction(p);
      const Construction mine{plane(how.a), plane(how.b), plane(how.c), point(how.line_from),
                              point(how.line_to)};
      made = to_.add_point(mine, from_.position(p));
    }
    points_[p.value()] = made.value();
    return made;
  }

  PlaneId plane(PlaneId s) {
    if (!s.valid()) return s;
    const std::uint32_t known = planes_[s.value()];
    if (known != IdMap::none) return PlaneId(known);
    const PlaneId made = copy(from_.definition(s));
    planes_[s.value()] = made.value();
    return made;
  }

 private:
  PlaneId copy(PlaneDefinition how) {
    using Kind = PlaneDefinition::Kind;
    if (how.kind() == Kind::coefficients) return to_.add_plane(from_.coefficients[how.a]);
    how.a = point(PointId(how.a)).value();
    how.b = point(PointId(how.b)).value();
    if (how.kind() == Kind::three_points) how.c = point(PointId(how.c)).value();
    return to_.add_plane(how);
  }

  const Geometry& from_;
  Geometry& to_;
  IdMap points_, planes_;
};

// All tables at once, by adding offsets.
void append_geometry(const Geometry& from, Geometry& to, std::uint32_t& points,
                     std::uint32_t& planes) {
  using Kind = PlaneDefinition::Kind;
  points = static_cast<std::uint32_t>(to.positions.size());
  planes = static_cast<std::uint32_t>(to.planes.size());
  const auto constructions = static_cast<std::uint32_t>(to.constructions.size());
  const auto coefficients = static_cast<std::uint32_t>(to.coefficients.size());
  to.positions.insert(to.positions.end(), from.positions.begin(), from.positions.end());
  to.coefficients.insert(to.coefficients.end(), from.coefficients.begin(), from.coefficients.end());
  to.construct.reserve(to.construct.size() + from.construct.size());
  for (const std::uint32_t c : from.construct)
    to.construct.push_back(c == Geometry::explicit_point ? c : c + constructions);
  const auto moved_point = [&](PointId p) { return p.valid() ? PointId(p.value() + points) : p; };
  const auto moved_plane = [&](PlaneId s) { return PlaneId(s.value() + planes); };
  for (const Construction& c : from.constructions)
    to.constructions.push_back({moved_plane(c.a), moved_plane(c.b), moved_plane(c.c),
                                moved_point(c.line_from), moved_point(c.line_to)});
  to.planes.reserve(to.planes.size() + from.planes.size());
  for (PlaneDefinition s : from.planes) {
    if (s.kind() == Kind::coefficients) {
      s.a += coefficients;
    } else {
      if (s.kind() == Kind::three_points) s.c += points;
      s.a += points;
      s.b += points;
    }
    to.planes.push_back(s);
  }
}

Patch load_whole(const SolidData& solid, Geometry& geometry) {
  Patch patch;
  std::uint32_t points, planes;
  append_geometry(solid.geometry(), geometry, points, planes);
  patch.brep = solid.brep();
  for (PlaneId& s : patch.brep.plane) s = PlaneId(s.value() + planes);
  for (PlaneId& s : patch.brep.edge_plane)
    if (s.valid()) s = PlaneId(s.value() + planes);
  for (PointId& p : patch.brep.point) p = PointId(p.value() + points);
  patch.brep.kind.assign(patch.brep.face_count(), FaceKind::real);
  patch.face_in_solid.resize(patch.brep.face_count());
  for (std::size_t f = 0; f < patch.face_in_solid.size(); ++f) patch.face_in_solid[f] = FaceId(f);
  patch.half_edge_in_solid.assign(patch.brep.half_edge_count(), HalfEdgeId());
  patch.side_plane.resize(patch.brep.half_edge_count());
  patch.whole = true;
  return patch;
}

class PartLoader {
 public:
  PartLoader(const SolidData& solid, const std::vector<FaceId>& faces, Geometry& geometry)
      : from_(solid.brep()),
        edges_(3 * faces.size()),
        geometry_(solid.geometry(), geometry, 3 * faces.size()) {
    for (const FaceId f : faces) load_face(f);
    close_open_ends();
    make_vertices();
  }

  Patch take() { return std::move(patch_); }

 private:
  HalfEdgeId local(HalfEdgeId h) {
    std::uint32_t& slot = edges_[Brep::edge_of(h).value()];
    if (slot == IdMap::none) {
      Brep& to = patch_.brep;
      slot = static_cast<std::uint32_t>(to.edge_count());
      const std::size_t count = to.half_edge_count() + 2;
      to.origin.resize(count);
      to.next.resize(count);
      to.prev.resize(count);
      to.loop.resize(count);
      patch_.edge_in_solid.push_back(Brep::edge_of(h));
      in_solid_.push_back(Brep::half_edge(Brep::edge_of(h), 0));
      in_solid_.push_back(Brep::half_edge(Brep::edge_of(h), 1));
      if (!from_.edge_plane.empty())
        to.edge_plane.push_back(geometry_.plane(from_.edge_plane[Brep::edge_of(h).value()]));
    }
    return Brep::half_edge(EdgeId(slot), h.value() & 1u);
  }

  FaceId add_face(PlaneId plane, FaceSource source, FaceKind kind) {
    Brep& to = patch_.brep;
    to.outer_loop.push_back(LoopId());
    to.plane.push_back(plane);
    to.source.push_back(source);
    to.kind.push_back(kind);
    return FaceId(to.face_count() - 1);
  }

  LoopId add_loop(FaceId face, LoopId& last) {
    Brep& to = patch_.brep;
    const LoopId loop(to.loop_count());
    to.loop_half_edge.push_back(HalfEdgeId());
    to.loop_face.push_back(face);
    to.next_loop.push_back(LoopId());
    if (last.valid())
      to.next_loop[last.value()] = loop;
    else
      to.outer_loop[face.value()] = loop;
    last = loop;
    return loop;
  }

  void load_face(FaceId f) {
    const FaceId mine =
        add_face(geometry_.plane(from_.plane[f.value()]), from_.source[f.value()], FaceKind::real);
    patch_.face_in_solid.push_back(f);
    LoopId last;
    for (LoopId l = from_.outer_loop[f.value()]; l.valid(); l = from_.next_loop[l.value()]) {
      const LoopId loop = add_loop(mine, last);
      Brep& to = patch_.brep;
      for_each_in_loop(from_, l, [&](HalfEdgeId h) {
        const HalfEdgeId here = local(h), after = local(from_.next_of(h));
        to.next[here.value()] = after;
        to.prev[after.value()] = here;
        to.loop[here.value()] = loop;
        to.loop_half_edge[loop.value()] = here;
      });
    }
  }

  // A half-edge without a loaded face is followed by the one that ends the fan of loaded faces
  // around its end.
  void close_open_ends() {
    Brep& to = patch_.brep;
    patch_.half_edge_in_solid.assign(to.half_edge_count(), HalfEdgeId());
    patch_.side_plane.resize(to.half_edge_count());
    std::vector<HalfEdgeId> open;
    for (std::size_t i = 0; i < to.half_edge_count(); ++i)
      if (!to.loop[i].valid()) open.push_back(HalfEdgeId(i));
    for (const HalfEdgeId h : open) {
      patch_.half_edge_in_solid[h.value()] = in_solid_[h.value()];
      // The plane beyond the open end still bounds the loaded face's edge.
      patch_.side_plane[Brep::twin(h).value()] =
          geometry_.plane(from_.plane_of(in_solid_[h.value()]));
      HalfEdgeId after = Brep::twin(h);
      do after = Brep::twin(to.prev_of(after));
      while (to.loop[after.value()].valid());
      to.next[h.value()] = after;
      to.prev[after.value()] = h;
    }
    for (const HalfEdgeId h : open) {
      if (to.loop[h.value()].valid()) continue;
      LoopId last;
      const FaceId rest = add_face(PlaneId(), FaceSource{}, FaceKind::rest);
      const LoopId loop = add_loop(rest, last);
      to.loop_half_edge[loop.value()] = h;
      for (HalfEdgeId i = h; !to.loop[i.value()].valid(); i = to.next_of(i))
        to.loop[i.value()] = loop;
    }
  }

  void make_vertices() {
    Brep& to = patch_.brep;
    for (std::size_t i = 0; i < to.half_edge_count(); ++i) {
      if (to.origin[i].valid()) continue;
      const HalfEdgeId first{i};
      const VertexId v(to.vertex_count()), there = from_.from(in_solid_[i]);
      patch_.vertex_in_solid.push_back(there);
      to.point.push_back(geometry_.point(from_.point_of(there)));
      to.vertex_half_edge.push_back(first);
      HalfEdgeId h = first;
      do {
        to.origin[h.value()] = v;
        if (to.kind[to.face_of(h).value()] == FaceKind::real) to.vertex_half_edge.back() = h;
        h = to.around(h);
      } while (h != first);
    }
  }

  const Brep& from_;
  Patch patch_;
  IdMap edges_;
  GeometryLoader geometry_;
  std::vector<HalfEdgeId> in_solid_;  // per local half-edge
};

}  // namespace

Patch load_patch(const SolidData& solid, const std::vector<FaceId>& faces, Geometry& geometry) {
  Patch patch = 2 * faces.size() >= solid.brep().face_count()
                    ? load_whole(solid, geometry)
                    : PartLoader(solid, faces, geometry).take();
  patch.solid = &solid;
  patch.loaded_faces = patch.face_in_solid.size();
  patch.loaded_edges = patch.brep.edge_count();
  patch.loaded_vertices = patch.brep.vertex_count();
  return patch;
}

void Patch::reserve(std::size_t more_edges) {
  brep.reserve(more_edges, more_edges, more_edges);
  side_plane.reserve(side_plane.size() + 2 * more_edges);
  half_edge_in_solid.reserve(half_edge_in_solid.size() + 2 * more_edges);
  root.reserve(root.size() + more_edges);
}

PointId load_point(const Geometry& from, PointId point, Geometry& to) {
  return GeometryLoader(from, to, 8).point(point);
}

Patch half_space_patch(PlaneId plane, FaceSource source) {
  Patch patch;
  patch.brep.outer_loop.push_back(LoopId());
  patch.brep.plane.push_back(plane);
  patch.brep.source.push_back(source);
  patch.brep.kind.push_back(FaceKind::real);
  patch.face_in_solid.push_back(FaceId());
  patch.loaded_faces = 1;
  patch.whole = true;
  patch.unbounded = true;
  return patch;
}

namespace {

// The plane that pins down a flat edge.
PlaneId pinning_plane(Patch& patch, EdgeId e, Geometry& geometry, const Kernel& kernel) {
  Brep& brep = patch.brep;
  if (const PlaneId known = brep.extra_plane(e); known.valid()) return known;
  const HalfEdgeId h = Brep::half_edge(e);
  const PointId from = brep.point_of(brep.from(h)), to = brep.point_of(brep.to(h));
  if (!geometry.is_explicit(from) || !geometry.is_explicit(to))
    throw InternalError("a flat edge between implicit points has no plane of its own");
  const FaceId face =
      patch.is_real(brep.face_of(h)) ? brep.face_of(h) : brep.face_of(Brep::twin(h));
  const int axis = kernel.main_axis(patch.plane(face));
  const PlaneId made = geometry.add_plane(PlaneDefinition::along_axis(from, to, axis));
  if (brep.edge_plane.empty()) brep.edge_plane.resize(brep.edge_count());
  return brep.edge_plane[e.value()] = made;
}

void find_sides(Patch& patch, Geometry& geometry, const Kernel& kernel) {
  Brep& brep = patch.brep;
  patch.flat.assign(brep.edge_count(), 0);
  for (std::size_t i = 0; i < brep.edge_count(); ++i) {
    const EdgeId e{i};
    PlaneId planes[2];
    for (unsigned side = 0; side < 2; ++side) {
      const HalfEdgeId h = Brep::half_edge(e, side);
      const FaceId f = brep.face_of(h);
      planes[side] = patch.is_real(f) ? patch.plane(f) : patch.side(Brep::twin(h));
    }
    PlaneId sides[2] = {planes[1], planes[0]};
    if (kernel.parallel(planes[0], planes[1])) {
      patch.flat[i] = 1;
      sides[0] = sides[1] = pinning_plane(patch, e, geometry, kernel);
    }
    for (unsigned side = 0; side < 2; ++side)
      patch.side_plane[Brep::half_edge(e, side).value()] = sides[side];
  }
}

void find_boxes(Patch& patch, const Geometry& geometry) {
  const Brep& brep = patch.brep;
  patch.face_boxes.resize(patch.loaded_faces);
  patch.half_edge_tree.resize(patch.loaded_faces);
  patch.tree_half_edges.resize(patch.loaded_faces);
  for (std::size_t i = 0; i < patch.loaded_faces; ++i) {
    Bounds bounds;
    std::size_t corners = 0;
    for_each_in_face(brep, FaceId(i), [&](HalfEdgeId h) {
      bounds.add(geometry.position(brep.point_of(brep.from(h))));
      ++corners;
    });
    patch.face_boxes[i] = bounds.box();
    if (corners < many_corners) continue;
    std::vector<Box> boxes;
    for_each_in_face(brep, FaceId(i), [&](HalfEdgeId h) {
      Bounds edge;
      edge.add(geometry.position(brep.point_of(brep.from(h))));
      edge.add(geometry.position(brep.point_of(brep.to(h))));
      boxes.push_back(edge.box());
      patch.tree_half_edges[i].push_back(h);
    });
    patch.half_edge_tree[i] = std::make_unique<BoxTree>(boxes);
  }
}

}  // namespace

void complete_patch(Patch& patch, Geometry& geometry, Kernel& kernel) {
  patch.root.resize(patch.brep.face_count());
  for (std::size_t f = 0; f < patch.root.size(); ++f) patch.root[f] = FaceId(f);
  find_sides(patch, geometry, kernel);
  kernel.refresh();
  find_boxes(patch, geometry);
}

}  // namespace sectile
