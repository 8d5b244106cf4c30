// From what the result is glued: the faces that stay of both patches, and of blocks that are made
// anew. They have places in one order, by which the result is numbered.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "boolean/gluing/kept_blocks.h"
#include "boolean/joining/joining.h"
#include "boolean/neighborhoods/neighborhoods.h"
#include "storage/geometry_loader.h"

namespace sectile {

/// A half-edge of a source.
struct SourceHalfEdge {
  std::uint32_t source = 0;
  HalfEdgeId h;
};

/// A patch, or a block that is made anew.
struct GlueSource {
  Operand operand;
  std::uint32_t slot;  ///< of the block; `patch` otherwise
  const Brep* brep;
  bool turned;                               ///< do its faces turn their other sides outwards?
  std::unique_ptr<GeometryLoader> geometry;  ///< of a block of which few faces stay
  GeometryOffset offset;                     ///< of any other: where its geometry is
  Table<PlaneId, PlaneId> turned_planes;     ///< of a patch that is turned
  Table<FaceId, std::uint32_t> place;        ///< of a face that stays, or `nowhere`
  Table<HalfEdgeId, HalfEdgeId> made;        ///< what is made of it
  /// Of a patch: does it only continue the half-edge before it (Wedges::continued)? Empty if none
  /// does.
  Table<HalfEdgeId, std::uint8_t> continued;

  static constexpr std::uint32_t patch = 0xFFFFFFFFu, nowhere = 0xFFFFFFFFu;

  /// In the workspace's geometry: of a point or a plane, and of a face's plane in the result.
  PointId point(PointId p) const { return geometry ? geometry->known(p) : offset.point(p); }
  PlaneId plane(PlaneId s) const { return geometry ? geometry->known(s, false) : offset.plane(s); }
  PlaneId face_plane(FaceId f) const {
    const PlaneId s = brep->plane[f];
    return geometry ? geometry->known(s, turned) : turned ? turned_planes[s] : offset.plane(s);
  }
  /// Is it an edge between the two sides of a cut, of which nothing stays, or a part of what is
  /// made of another one?
  bool is_passed_over(HalfEdgeId h) const {
    return (slot == patch && brep->point_of(brep->from(h)) == brep->point_of(brep->to(h))) ||
           (!continued.empty() && continued[h] != 0);
  }
};

class GlueSources {
 public:
  /// Adds points of blocks and turned planes to the workspace's geometry.
  GlueSources(Workspace& w, Operation operation, const FaceLabels& kept, const KeptBlocks& blocks);

  /// The two half-edges of each pair of wedges are mates from now on.
  void pair_sides(const Neighborhoods& n, const Wedges& wedges, const JoinedCuts& joined);

  /// A face that stays.
  struct Kept {
    std::uint32_t source;
    FaceId face;
  };
  std::span<const Kept> faces() const { return faces_; }
  GlueSource& operator[](std::uint32_t source) { return sources_[source]; }
  const GlueSource& operator[](std::uint32_t source) const { return sources_[source]; }

  /// The other half of an edge of the result.
  struct Mate {
    enum class Kind : std::uint8_t {
      glued,    ///< a half-edge of a source
      earlier,  ///< one of a loaded face, whose mate this one is
      shared    ///< of a block that is shared
    };
    Kind kind;
    bool seam;          ///< are two sides of cuts glued here?
    SourceHalfEdge h;   ///< if glued
    BorderEdge border;  ///< if shared
  };
  Mate mate(const SourceHalfEdge& e) const;
  /// The place of a half-edge's face.
  std::uint32_t place(const SourceHalfEdge& e) const {
    const GlueSource& from = sources_[e.source];
    return from.place[from.brep->face_of(e.h)];
  }

 private:
  struct Partner {
    HalfEdgeId h;
    Operand operand;
  };
  template <class Stays>
  void add_faces(GlueSource& source, const Stays& stays);
  void add_block(Geometry& geometry, Operand s, std::uint32_t slot, bool turned);
  void load_geometry(GlueSource& source);
  void turn_planes(Geometry& geometry, GlueSource& source);
  Mate in_slot(Operand s, std::uint32_t slot, HalfEdgeId h) const;

  const Workspace& w_;
  const FaceLabels& kept_;
  const KeptBlocks& blocks_;
  std::vector<GlueSource> sources_;  // patch A, patch B, blocks
  PerOperand<std::vector<std::uint32_t>> source_of_slot_;
  PerOperand<Table<HalfEdgeId, Partner>> partner_;  // per half-edge of a patch
  std::vector<Kept> faces_;
};

}  // namespace sectile
