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

/// A face's half-edge with the sides of its ends relative to another face's plane.
struct SidedHalfEdge {
  HalfEdgeId h;
  Sign from, to;
  bool meets_plane() const { return from == Sign::zero || from * to == Sign::negative; }
};

struct PairOfFaces {
  FaceId face[2];
  bool coplanar;
  /// Indices in ContactTable::sided of the half-edges of both faces that meet the other's plane.
  std::uint32_t first_sided[2], last_sided[2];
};

/// Where the hits of each edge and vertex of a solid begin in a list that is ascending by key.
class HitsOfPiercers {
 public:
  HitsOfPiercers() = default;
  HitsOfPiercers(std::span<const Hit> hits, const Brep& brep);
  /// The numbers of the first hit and of the one behind the last.
  std::pair<std::uint32_t, std::uint32_t> operator[](Entity piercer) const {
    const std::size_t at = piercer.is_edge() ? piercer.index() + vertices_ : piercer.index();
    return {first_[at], first_[at + 1]};
  }

 private:
  std::size_t vertices_ = 0;
  std::vector<std::uint32_t> first_;  // vertices, then edges, then the end
};

/// The outcome of the tests of all pairs. [s]: the piercer or edge belongs to solid s.
struct ContactTable {
  std::vector<Hit> hits[2];  ///< ascending by key
  HitsOfPiercers hits_of[2];
  std::vector<InPlane> in_plane[2];
  std::vector<std::pair<EdgeId, EdgeId>> flat_crossings;
  std::vector<PairOfFaces> pairs;  ///< not separated by one of their planes
  std::vector<SidedHalfEdge> sided[2];

  /// Where a piercer meets a face; on several entities where the face touches itself.
  std::span<const Hit> find(int solid, Entity piercer, FaceId face) const;
  /// The half-edges of one face of a pair that meet the other one's plane.
  std::span<const SidedHalfEdge> meeting(const PairOfFaces& pair, int solid) const {
    return std::span(sided[solid])
        .subspan(pair.first_sided[solid], pair.last_sided[solid] - pair.first_sided[solid]);
  }
};

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
