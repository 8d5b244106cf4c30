// The trace: what each phase of an operation did, for debugging, for the viewer, and as JSON.
#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
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

/// A vertex, an edge or a face, with the number that it has in the operand. What the operation made
/// is counted on from there. Prints as v12, e3, f7.
struct TraceEntity {
  enum class Kind : std::uint8_t { vertex, edge, face };
  Kind kind = Kind::vertex;
  std::uint32_t number = 0;
  bool is_vertex() const { return kind == Kind::vertex; }
  bool is_edge() const { return kind == Kind::edge; }
  bool is_face() const { return kind == Kind::face; }
  friend bool operator==(const TraceEntity&, const TraceEntity&) = default;
};
std::string name_of(const TraceEntity& entity);
/// "vertex", "edge", "face".
std::string_view word_for(TraceEntity::Kind kind);

/// A contact point: its number among all of them, and its coordinates, rounded.
struct TracePlace {
  static constexpr std::uint32_t no_number = 0xFFFFFFFFu;
  std::uint32_t number = no_number;
  Vec3 point;
};

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

/// Where a piece of one boundary lies: in or outside the other solid, or on its boundary with the
/// same or the opposite normal. Prints as in, out, on+, on-.
enum class TraceClass : std::uint8_t { in, on_plus, on_minus, out };
std::string_view name_of(TraceClass cls);
inline bool is_on(TraceClass cls) {
  return cls == TraceClass::on_plus || cls == TraceClass::on_minus;
}

/// One side of a face or an edge at a contact segment. Directions as above.
struct TraceHalfPlane {
  std::uint8_t solid = 0;
  bool forward = true;  ///< material lies clockwise of it, seen against the segment's direction
  std::uint32_t face = 0;
  TraceEntity carrier;  ///< the face or edge that has the segment
  Vec3 direction;       ///< away from the segment, into the face
  Vec3 normal;          ///< of the face, outwards
  TraceClass before = TraceClass::in;
  TraceClass after = TraceClass::in;  ///< reclassified by Table I: in or out
  int coplanar = -1;  ///< the half-plane of the other solid on which it lies (an index), or -1
  bool kept = false;  ///< in the boundary of the result
  bool cut = false;   ///< its carrier is cut along the segment
};
/// Table I: the class that a piece of a solid's boundary gets for an operation.
TraceClass reclassified(Operation operation, int solid, TraceClass before);
/// Both classes and what follows, in one line.
std::string describe(const TraceHalfPlane& half_plane);

// What the phases find and do. `ends` are those of a segment.

/// An entity of A and one of B share a point.
struct ContactEvent {
  TraceEntity a, b;
  TracePlace place;
  std::vector<TraceSector> sectors;  ///< cycles of A's, then of B's
};
/// An entity of A and one of B share a segment.
struct SegmentEvent {
  TraceEntity a, b;
  std::array<TracePlace, 2> ends;
};
struct NeighborhoodEvent {
  std::vector<TraceEntity> a, b;  ///< all that have the segment
  std::array<TracePlace, 2> ends;
  /// Counter-clockwise, seen against the direction of the segment.
  std::vector<TraceHalfPlane> half_planes;
};
struct NullEdgeEvent {
  /// The cuts for which it was made.
  struct Site {
    TraceEntity at;
    std::uint32_t cuts = 0;
  };
  std::uint8_t solid = 0;
  TraceEntity edge, from, to;
  TracePlace place;           ///< without a number if it has no site
  std::optional<Site> site;   ///< or it links corners that touch each other
  std::array<Vec3, 2> pulls;  ///< how its two ends move apart; length 0 … 1
};
/// A cut of a face or beside an edge, from one null edge to another.
struct CutEvent {
  std::uint8_t solid = 0;
  TraceEntity carrier;
  std::array<TracePlace, 2> ends;
  std::uint32_t forward_side = 0, backward_side = 0;  ///< half-edges
};
/// A part of a boundary: what lies in, or outside, the other solid.
struct PartEvent {
  enum class Fate : std::uint8_t { dropped, kept, turned };
  std::uint8_t solid = 0;
  TraceClass side = TraceClass::in;
  Fate fate = Fate::dropped;
  std::size_t faces = 0;
};
/// "AinB", "AonB+", …
std::string part_name(int solid, TraceClass cls);
/// "dropped", "kept", "kept, turned inside out".
std::string_view name_of(PartEvent::Fate fate);
/// Two faces that bound one wedge of the result's material along a segment.
struct WedgeEvent {
  struct Side {
    std::uint8_t solid = 0;
    TraceEntity face;
  };
  std::array<TracePlace, 2> ends;
  std::array<Side, 2> between;
  bool glued = false;  ///< or never apart
};
/// "A f3 and B f7".
std::string describe(const std::array<WedgeEvent::Side, 2>& between);
struct ResultEvent {
  SolidCounts counts;
};

using TraceEvent = std::variant<ContactEvent, SegmentEvent, NeighborhoodEvent, NullEdgeEvent,
                                CutEvent, PartEvent, WedgeEvent, ResultEvent>;

/// "contact", "segment", "neighborhood", "null edge", "cut", "part", "wedge", "result".
std::string_view kind_of(const TraceEvent& event);
/// The one place, or the two ends of a segment, or none.
std::span<const TracePlace> places_of(const TraceEvent& event);
/// The entities of a solid that it is about, if any.
std::vector<TraceEntity> entities_of(const TraceEvent& event, int solid);
/// "vertex on face": what meets in a contact or a segment of these.
std::string meeting_of(const TraceEntity& a, const TraceEntity& b);

/// The place in the paper that settles a neighborhood, as far as its geometry is one of the paper's
/// cases, and what is said there.
struct PaperRule {
  std::string where;  ///< e.g. "Table II, row 4"
  std::string says;   ///< a sentence
};
PaperRule paper_rule(const NeighborhoodEvent& neighborhood, Operation operation);

/// Is told what each phase did, once per phase and in order, by the thread that runs the operation.
class Observer {
 public:
  virtual ~Observer() = default;
  virtual void phase_done(Phase phase, const std::vector<TraceEvent>& events) = 0;
};

/// Runs an operation and writes all that its phases report, as one JSON document.
void write_trace(std::ostream& out, const Solid& a, const Solid& b, Operation operation);

}  // namespace sectile
