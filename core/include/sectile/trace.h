// The trace: what each phase of an operation did, for debugging, for the viewer, and as JSON.
#pragma once

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
  vertex_vertex,  ///< neighborhoods of coincident vertices and edges (6.2)
  null_edges,     ///< neighborhoods split by null edges
  joining,        ///< null edges joined along the cuts
  components,     ///< the cut surfaces fall apart
  gluing,         ///< wedges of material glued
  cleanup         ///< the finished result
};
std::string_view name_of(Phase phase);

/// One thing that a phase found or did. Entities print as v12, e3, f7; those of A come first.
struct TraceEvent {
  std::string kind;          ///< e.g. "contact", "segment", "null edge", "cut", "part", "result"
  std::string a, b;          ///< the entities of A and of B concerned, if any
  std::vector<Vec3> points;  ///< one place, or the two ends of a segment
  std::vector<std::pair<std::string, std::string>> facts;  ///< name and value, in words
};

/// Is told what each phase did, once per phase and in order, by the thread that runs the operation.
class Observer {
 public:
  virtual ~Observer() = default;
  virtual void phase_done(Phase phase, const std::vector<TraceEvent>& events) = 0;
};

/// Runs an operation and writes all that its phases report, as one JSON document.
void write_trace(std::ostream& out, const Solid& a, const Solid& b, Operation operation);

}  // namespace sectile
