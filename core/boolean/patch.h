// The part of an operand that may meet the other one, loaded into the workspace.
//
// What is not loaded is represented by faces of kind `rest`, so that the patch is a closed
// structure at all times. A solid of which much is touched is loaded whole.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "boolean/loading/far_loops.h"
#include "boolean/operand.h"
#include "boolean/tested.h"
#include "numbers/table.h"
#include "search/outline_tree.h"
#include "storage/solid_data.h"

namespace sectile {

class CrowdedCorners;

struct Patch {
  Brep brep;
  const SolidData* solid = nullptr;  ///< none for a half-space

  /// Per loaded face: the operand's face.
  std::vector<FaceId> face_in_solid;
  /// Per loaded edge and vertex: the operand's. Empty if all of it is loaded.
  std::vector<EdgeId> edge_in_solid;
  std::vector<VertexId> vertex_in_solid;
  /// Of a loaded half-edge of an open end (in a rest face): the operand's half-edge; otherwise
  /// invalid. Empty if all of it is loaded.
  Table<HalfEdgeId, HalfEdgeId> half_edge_in_solid;
  /// Does a loaded edge lie between coplanar faces?
  Table<EdgeId, std::uint8_t> flat;
  // What follows grows with the structure: see PatchEuler.
  /// The loaded face of which a face is a part.
  Table<FaceId, FaceId> root;
  /// A plane through a half-edge that is not parallel to its face's plane; invalid for null edges.
  Table<HalfEdgeId, PlaneId> side_plane;

  /// A tree over the half-edges of a face.
  struct Outline {
    OutlineTree tree;
    std::vector<HalfEdgeId> half_edges;
  };
  /// Per loaded face with many corners; empty if there is none.
  std::vector<std::unique_ptr<const Outline>> outlines;
  std::vector<Box> face_boxes;
  /// Very many corners in one point, of a loaded face with an outline, until the patch is cut.
  struct CrowdedFace {
    FaceId face;
    std::shared_ptr<const CrowdedCorners> corners;
  };
  std::vector<CrowdedFace> crowded;  ///< ascending, as a rule none

  /// In the order of their faces and slots.
  std::vector<FarLoops> far_loops;

  Tested tested;
  /// Per loaded vertex: is it where both boundaries may meet without a contact that says so
  /// (boolean/near/crowded_lines.h)? The number of the line, from 1 on, or `several`. Empty if
  /// there is no such place.
  Table<VertexId, std::uint32_t> on_crowded_line;
  static constexpr std::uint32_t several = 0xFFFFFFFFu;

  std::size_t loaded_faces = 0, loaded_edges = 0, loaded_vertices = 0;
  bool whole = false;  ///< all faces of the operand are loaded
  /// The half-space's face has no boundary and reaches to infinity.
  bool unbounded = false;

  /// Room for this many more edges, and as many loops, faces and vertices.
  void reserve(std::size_t more_edges);

  bool is_real(FaceId f) const { return brep.kind[f] == FaceKind::real; }
  PlaneId plane(FaceId f) const { return brep.plane[f]; }
  const Outline* outline(FaceId f) const {
    return outlines.empty() ? nullptr : outlines[f.value()].get();
  }
  const CrowdedCorners* crowded_corners(FaceId f) const {
    const auto at = std::ranges::lower_bound(crowded, f, {}, &CrowdedFace::face);
    return at == crowded.end() || at->face != f ? nullptr : at->corners.get();
  }
  PlaneId side(HalfEdgeId h) const { return side_plane[h]; }
  bool is_flat(EdgeId e) const { return flat[e] != 0; }
  FaceId root_of(FaceId f) const { return root[f]; }
  FaceId root_of(HalfEdgeId h) const { return root[brep.face_of(h)]; }
  /// Do both ends lie at one place?
  bool is_null(HalfEdgeId h) const {
    return brep.point_of(brep.from(h)) == brep.point_of(brep.to(h));
  }
  /// The face that speaks for an edge or vertex when pairs of faces are enumerated.
  FaceId owner(EdgeId e) const {
    const FaceId f = brep.face_of(Brep::half_edge(e, 0));
    return is_real(f) ? f : brep.face_of(Brep::half_edge(e, 1));
  }
  FaceId owner(VertexId v) const { return brep.face_of(brep.vertex_half_edge[v]); }
  /// Those of a loaded face, or of the face in a slot; none if there are none.
  const FarLoops* far_loops_of(FaceId loaded) const;
  const FarLoops* far_loops_in(std::uint32_t slot) const;
  /// The part of a face to which a half-edge of a far loop belongs; none if it is no such.
  FaceId part_of_far(std::uint32_t slot, HalfEdgeId h) const;
};

/// Loads the given faces (ascending) of a solid, without their far loops; its points and planes are
/// added to `geometry`. There is room for so many more edges.
Patch load_patch(const SolidData& solid, const std::vector<FaceId>& faces, Geometry& geometry,
                 std::size_t more_edges = 0, std::vector<FarLoops> far_loops = {});
/// The loaded face that stands for a face of the operand.
FaceId loaded_face(const Patch& patch, FaceId face);
/// Appends the geometry of a patch to another one, of which the patch's is a part then.
void move_to_end(Patch& patch, const Geometry& own, Geometry& geometry);

/// Loads a point; it may become a second one at the same place.
PointId load_point(const Geometry& from, PointId point, Geometry& to);

/// The boundary of a half-space: one face without boundary. The normal points out of it.
Patch half_space_patch(PlaneId plane, FaceSource source);

class Kernel;
/// Fills root, flat, side_plane, boxes and trees of both; needs the kernel for the workspace's
/// geometry, which may be given further planes.
void complete_patches(PerOperand<Patch>& patches, Geometry& geometry, Kernel& kernel);

}  // namespace sectile
