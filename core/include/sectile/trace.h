// The trace: what each phase of an operation did, for debugging, for the viewer, and as JSON.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sectile/boolean.h"

namespace sectile {

/// The phases of the algorithm, in order.
enum class Phase {
  reduction,      ///< contacts of the two boundaries (paper, section 5)
  vertex_face,    ///< neighborhoods of vertices within faces (6.1)
  vertex_vertex,  ///< neighborhoods of coincident vertices (6.2)
  null_edges,     ///< neighborhoods split by null edges
  joining,        ///< null edges joined along the cuts
  components,     ///< the cut surfaces fall apart
  gluing,         ///< wedges of material glued
  cleanup         ///< the finished result
};
std::string_view name_of(Phase phase);

/// What a face has around a contact point: its corner there, its half beside an edge, or all of it.
/// Directions have length one and are rounded: they are for drawing.
struct TraceSector {
  static constexpr std::uint32_t no_edge = 0xFFFFFFFFu;
  std::uint8_t solid = 0;  ///< 0: A, 1: B
  std::uint32_t face = 0;
  std::uint32_t from_edge = no_edge, to_edge = no_edge;
  /// It reaches counter-clockwise, seen from outside, from one direction to the other. Both are
  /// zero if the point lies inside the face.
  Vec3 from, to;
  Vec3 normal;  ///< of the face, outwards
};

/// One side of a face or an edge at a contact segment. Directions as above.
struct TraceHalfPlane {
  std::uint8_t solid = 0;
  bool forward = true;  ///< material lies clockwise of it, seen against the segment's direction
  std::uint32_t face = 0;
  std::string carrier;      ///< the face or edge that has the segment: f7, e3
  Vec3 direction;           ///< away from the segment, into the face
  Vec3 normal;              ///< of the face, outwards
  std::string_view before;  ///< its class: in, out, on+, on-
  std::string_view after;   ///< reclassified by Table I: in, out
  int coplanar = -1;  ///< the half-plane of the other solid on which it lies (an index), or -1
  bool kept = false;  ///< in the boundary of the result
  bool cut = false;   ///< its carrier is cut along the segment
};
/// Table I: the class (as in `before`) that a piece of a solid's boundary gets for an operation.
std::string_view reclassified(Operation operation, int solid, std::string_view before);
/// Both classes and what follows, in one line.
std::string describe(const TraceHalfPlane& half_plane);

/// One thing that a phase found or did. Entities print as v12, e3, f7, with the numbers that they
/// have in the operand; those that the operation made are counted on from there.
struct TraceEvent {
  std::string kind;  ///< contact, segment, neighborhood, null edge, cut, part, wedge, result
  std::string a, b;  ///< the entities of A and of B concerned, if any
  std::vector<Vec3> points;  ///< one place, or the two ends of a segment
  std::vector<std::pair<std::string, std::string>> facts;  ///< name and value, in words
  std::vector<std::uint32_t> places;  ///< the numbers of the points among all contact points
  std::vector<TraceSector> sectors;   ///< of a contact: cycles of A's, then of B's
  /// Of a neighborhood: counter-clockwise, seen against the direction of the segment.
  std::vector<TraceHalfPlane> half_planes;
  std::vector<Vec3> pulls;  ///< of a null edge: how its two ends move apart; length 0 … 1

  /// The value of a fact, or nothing.
  std::string_view fact(std::string_view name) const;
};

/// The place in the paper that settles a neighborhood, as far as its geometry is one of the paper's
/// cases, and what is said there.
struct PaperRule {
  std::string where;  ///< e.g. "Table II, row 4"
  std::string says;   ///< a sentence
};
PaperRule paper_rule(const TraceEvent& neighborhood, Operation operation);

/// Is told what each phase did, once per phase and in order, by the thread that runs the operation.
class Observer {
 public:
  virtual ~Observer() = default;
  virtual void phase_done(Phase phase, const std::vector<TraceEvent>& events) = 0;
};

/// Runs an operation and writes all that its phases report, as one JSON document.
void write_trace(std::ostream& out, const Solid& a, const Solid& b, Operation operation);

}  // namespace sectile
