// Inner tables of the reduction.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boolean/reduction/reduction.h"

namespace sectile {

/// An edge or vertex of one solid that meets a face of the other: where it does.
struct Hit {
  Entity piercer;
  FaceId face;
  Entity found;               ///< the face, or one of its edges or vertices
  std::uint32_t contact = 0;  ///< index in Workspace::contacts
  std::uint64_t key() const { return std::uint64_t(piercer.code()) << 32 | face.value(); }
};

/// An edge that lies in the plane of a face of the other solid.
struct InPlane {
  EdgeId edge;
  FaceId face;
};

struct PairOfFaces {
  FaceId face[2];
  bool coplanar;
};

/// The outcome of the tests of all pairs. [s]: the piercer or edge belongs to solid s.
struct ContactTable {
  std::vector<Hit> hits[2];  ///< ascending by key
  std::vector<InPlane> in_plane[2];
  std::vector<std::pair<EdgeId, EdgeId>> flat_crossings;
  std::vector<PairOfFaces> pairs;  ///< not separated by one of their planes

  /// Where a piercer meets a face; on several entities where the face touches itself.
  std::span<const Hit> find(int solid, Entity piercer, FaceId face) const;
};

/// A corner's half-edge with the sides of its ends relative to the other face's plane.
struct SidedHalfEdge {
  HalfEdgeId h;
  Sign from, to;
};

/// The half-edges of a face that come near a box, with their sides. Returns false if it is certain
/// that the face does not reach the plane.
bool sided_half_edges(const Workspace& w, int solid, FaceId face, FaceId other,
                      std::vector<SidedHalfEdge>& out);

/// Steps 1 to 8 for all pairs; fills Workspace::contacts.
ContactTable find_contacts(Workspace& w, const FacePairs& candidates);
/// Gives contacts at the same point the same place; those before the first one keep theirs.
void find_places(Workspace& w, std::size_t first_contact);
/// Finds the segments between the contacts of each pair.
void find_segments(Workspace& w, const ContactTable& table);
/// Divides the segments at all places within them.
void split_at_places(Workspace& w);
/// Adds places where edges of one operand cross each other in a face of the other. Returns whether
/// there are any.
bool add_crossings(Workspace& w);
/// Adds faces in which an operand touches itself along a segment.
void add_touched_faces(Workspace& w, const ContactTable& table);

}  // namespace sectile
