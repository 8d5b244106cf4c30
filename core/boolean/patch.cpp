#include "boolean/patch.h"

#include <algorithm>

#include "boolean/collect.h"
#include "boolean/loading/part_loader.h"
#include "boolean/side_by_side.h"
#include "geometry/kernel.h"
#include "numbers/threshold.h"
#include "sectile/errors.h"
#include "storage/geometry_loader.h"

namespace sectile {
namespace {

constexpr std::size_t many_corners = threshold(24, 4);

void shift(Brep& brep, const GeometryOffset& offset) {
  for (PlaneId& s : brep.plane) s = offset.plane(s);
  for (PlaneId& s : brep.edge_plane) s = offset.plane(s);
  for (PointId& p : brep.point) p = offset.point(p);
}

Patch load_whole(const SolidData& solid, Geometry& geometry, std::size_t more_edges) {
  Patch patch;
  patch.reserve(solid.brep().edge_count() + more_edges);
  const GeometryOffset offset = append_geometry(solid.geometry(), geometry);
  patch.brep = solid.brep();
  shift(patch.brep, offset);
  patch.brep.kind.assign(patch.brep.face_count(), FaceKind::real);
  patch.face_in_solid.resize(patch.brep.face_count());
  for (std::size_t f = 0; f < patch.face_in_solid.size(); ++f) patch.face_in_solid[f] = FaceId(f);
  patch.side_plane.resize(patch.brep.half_edge_count());
  patch.whole = true;
  return patch;
}

}  // namespace

Patch load_patch(const SolidData& solid, const std::vector<FaceId>& faces, Geometry& geometry,
                 std::size_t more_edges, std::vector<FarLoops> far_loops) {
  Patch patch = solid.is_whole() && 2 * faces.size() >= solid.face_count()
                    ? load_whole(solid, geometry, more_edges)
                    : PartLoader(solid, faces, geometry, more_edges, std::move(far_loops)).take();
  patch.solid = &solid;
  patch.loaded_faces = patch.face_in_solid.size();
  patch.loaded_edges = patch.brep.edge_count();
  patch.loaded_vertices = patch.brep.vertex_count();
  return patch;
}

FaceId loaded_face(const Patch& patch, FaceId face) {
  if (patch.whole) return face;
  const auto at = std::lower_bound(patch.face_in_solid.begin(), patch.face_in_solid.end(), face);
  return FaceId(static_cast<std::size_t>(at - patch.face_in_solid.begin()));
}

void move_to_end(Patch& patch, const Geometry& own, Geometry& geometry) {
  const GeometryOffset offset = append_geometry(own, geometry);
  shift(patch.brep, offset);
  for (PlaneId& s : patch.side_plane) s = offset.plane(s);
}

void Patch::reserve(std::size_t more_edges) {
  brep.reserve(more_edges, more_edges, more_edges);
  side_plane.reserve(side_plane.size() + 2 * more_edges);
  root.reserve(root.size() + more_edges);
}

namespace {

template <class Id>
const FarLoops* found(const std::vector<FarLoops>& all, Id id, Id FarLoops::*key) {
  const auto at = std::ranges::lower_bound(all, id, {}, key);
  return at == all.end() || (*at).*key != id ? nullptr : &*at;
}

}  // namespace

const FarLoops* Patch::far_loops_of(FaceId loaded) const {
  return found(far_loops, loaded, &FarLoops::face);
}

const FarLoops* Patch::far_loops_in(std::uint32_t slot) const {
  return found(far_loops, slot, &FarLoops::slot);
}

FaceId Patch::part_of_far(std::uint32_t slot, HalfEdgeId h) const {
  const FarLoops* far = far_loops_in(slot);
  return far ? far->part[solid->slot(slot).block->brep().loop_of(h)] : FaceId();
}

PointId load_point(const Geometry& from, PointId point, Geometry& to) {
  return GeometryLoader(from, to, 8).point(point);
}

Patch half_space_patch(PlaneId plane, FaceSource source) {
  Patch patch;
  patch.brep.add_face(plane, source);
  patch.brep.kind.add(FaceKind::real);
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
  if (geometry.is_constructed(from) || geometry.is_constructed(to))
    throw InternalError("a flat edge between implicit points has no plane of its own");
  const FaceId face =
      patch.is_real(brep.face_of(h)) ? brep.face_of(h) : brep.face_of(Brep::twin(h));
  const int axis = kernel.main_axis(patch.plane(face));
  const PlaneId made = geometry.add_plane(PlaneDefinition::along_axis(from, to, axis));
  if (brep.edge_plane.empty()) brep.edge_plane.resize(brep.edge_count());
  return brep.edge_plane[e] = made;
}

// Faces or edges that are looked at by one thread.
constexpr std::size_t grain = threshold(512, 4);

// Of flat edges only which they are.
void find_sides(Patch& patch, const Kernel& kernel) {
  const Brep& brep = patch.brep;
  patch.flat.resize_unwritten(brep.edge_count());
  const auto of_edge = [&](EdgeId e) {
    PlaneId planes[2];
    for (unsigned side = 0; side < 2; ++side) {
      const HalfEdgeId h = Brep::half_edge(e, side);
      const FaceId f = brep.face_of(h);
      planes[side] = patch.is_real(f) ? patch.plane(f) : patch.side(Brep::twin(h));
    }
    patch.flat[e] = kernel.parallel(planes[0], planes[1]) ? 1 : 0;
    for (unsigned side = 0; side < 2; ++side)
      patch.side_plane[Brep::half_edge(e, side)] = planes[1 - side];
  };
  parallel::loop(parallel::Range<std::size_t>(0, brep.edge_count(), grain), [&](const auto& some) {
    for (std::size_t e = some.begin(); e < some.end(); ++e) of_edge(EdgeId(e));
  });
}

void pin_flat_edges(Patch& patch, Geometry& geometry, const Kernel& kernel) {
  for (const EdgeId e : patch.flat.ids()) {
    if (!patch.is_flat(e)) continue;
    const PlaneId plane = pinning_plane(patch, e, geometry, kernel);
    for (unsigned side = 0; side < 2; ++side) patch.side_plane[Brep::half_edge(e, side)] = plane;
  }
}

// Returns those with many corners.
std::vector<FaceId> find_boxes(Patch& patch, const Geometry& geometry) {
  const Brep& brep = patch.brep;
  patch.face_boxes.resize(patch.loaded_faces);
  return joined(collect<std::vector<FaceId>>(
      patch.loaded_faces, grain, [&](std::size_t i, std::vector<FaceId>& with_many_corners) {
        Bounds bounds;
        std::size_t count = 0;
        for_each_in_face(brep, FaceId(i), [&](HalfEdgeId h) {
          bounds.add(geometry.position(brep.point_of(brep.from(h))));
          ++count;
        });
        patch.face_boxes[i] = bounds.box();
        if (count >= many_corners) with_many_corners.push_back(FaceId(i));
      }));
}

std::unique_ptr<const Patch::Outline> outline_of(const Brep& brep, FaceId face,
                                                 const Geometry& geometry, int axis) {
  std::vector<Vec3> corners;
  std::vector<std::uint32_t> loop_ends;
  std::vector<HalfEdgeId> half_edges;
  for (LoopId l = brep.outer_loop[face]; l.valid(); l = brep.next_loop[l]) {
    for_each_in_loop(brep, l, [&](HalfEdgeId h) {
      corners.push_back(geometry.position(brep.point_of(brep.from(h))));
      half_edges.push_back(h);
    });
    loop_ends.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  return std::make_unique<const Patch::Outline>(
      Patch::Outline{{corners, loop_ends, axis}, std::move(half_edges)});
}

void make_outlines(Patch& patch, std::span<const FaceId> faces, const Geometry& geometry,
                   const Kernel& kernel) {
  if (faces.empty()) return;
  patch.outlines.resize(patch.loaded_faces);
  parallel::loop(0, faces.size(), [&](std::size_t i) {
    patch.outlines[faces[i].value()] =
        outline_of(patch.brep, faces[i], geometry, kernel.main_axis(patch.plane(faces[i])));
  });
}

}  // namespace

void complete_patches(PerOperand<Patch>& patches, Geometry& geometry, Kernel& kernel) {
  const std::size_t faces = patches[Operand::a].loaded_faces + patches[Operand::b].loaded_faces;
  for_both_operands(faces, [&](Operand s) {
    Patch& patch = patches[s];
    patch.root.resize(patch.brep.face_count());
    for (const FaceId f : patch.root.ids()) patch.root[f] = f;
    find_sides(patch, kernel);
    make_outlines(patch, find_boxes(patch, geometry), geometry, kernel);
  });
  for (Patch& patch : patches) pin_flat_edges(patch, geometry, kernel);
  kernel.refresh();
}

}  // namespace sectile
