// Inner tables of the reduction.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boolean/entity_numbers.h"
#include "boolean/reduction/reduction.h"

namespace sectile {

/// An edge or vertex of one solid that meets a face of the other: where it does.
struct Hit {
  Entity piercer;
  FaceId face;
  Entity found;  ///< the face, or one of its edges or vertices
  ContactId contact;
  std::uint64_t key() const { return std::uint64_t(piercer.code()) << 32 | face.value(); }
};

/// An edge that lies in the plane of a face of the other solid.
struct InPlane {
  EdgeId edge;
  FaceId face;
};

/// A face's half-edge with the sides of its ends relative to another face's plane.
struct SidedHalfEdge {
  HalfEdgeId h;
  Sign from, to;
  bool meets_plane() const { return from == Sign::zero || from * to == Sign::negative; }
};

struct PairOfFaces {
  PerOperand<FaceId> face;
  bool coplanar;
  /// Indices in ContactTable::sided of the half-edges of both faces that meet the other's plane.
  PerOperand<std::uint32_t> first_sided, last_sided;
};

/// The outcome of the tests of all pairs. [s]: the piercer or edge belongs to solid s.
struct ContactTable {
  PerOperand<UnsetVector<Hit>> hits;  ///< ascending by key
  PerOperand<EntityNumbers> numbers;
  PerOperand<std::vector<std::uint32_t>> first_hit;  ///< per number of a piercer, and the end
  PerOperand<UnsetVector<InPlane>> in_plane;
  UnsetVector<PairOfFaces> pairs;  ///< not separated by one of their planes
  PerOperand<UnsetVector<SidedHalfEdge>> sided;

  /// Where a piercer meets a face; on several entities where the face touches itself.
  std::span<const Hit> find(Operand solid, Entity piercer, FaceId face) const;
  /// The half-edges of one face of a pair that meet the other one's plane.
  std::span<const SidedHalfEdge> meeting(const PairOfFaces& pair, Operand solid) const {
    return std::span(sided[solid])
        .subspan(pair.first_sided[solid], pair.last_sided[solid] - pair.first_sided[solid]);
  }
};

/// Steps 1 to 8 for all pairs; fills the contacts and places.
ContactTable find_contacts(Workspace& w, const FacePairs& candidates, Contacts& found);
/// Gives contacts at the same point the same place; those before the first one keep theirs.
void find_places(Workspace& w, ContactId first, Contacts& found);
/// Finds the segments between the contacts of each pair.
void find_segments(const Workspace& w, const ContactTable& table, Contacts& found);
/// Divides the segments of very many edges on one line at each other's ends: of the records along
/// each stretch, those are left that show an edge first.
void divide_rows(const Workspace& w, Contacts& found);
/// Divides the segments at all places within them.
void split_at_places(const Workspace& w, Contacts& found);
/// Adds places where edges of one operand cross each other in a face of the other. Returns whether
/// there are any.
bool add_crossings(Workspace& w, Contacts& found);
/// Adds faces in which an operand touches itself along a segment.
void add_touched_faces(const Workspace& w, const ContactTable& table, Contacts& found);

}  // namespace sectile
