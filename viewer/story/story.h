// The story of one Boolean: every phase and every step in it, in words, tables and pictures.
#pragma once

#include <array>
#include <atomic>
#include <string>
#include <utility>
#include <vector>

#include "picture/picture.h"
#include "sectile/sectile.h"

namespace sectile::viewer {

/// The neighborhood of a contact as seen on the unit sphere around it: arcs of A and of B.
struct SpherePicture {
  struct Arc {
    int solid = 0;                 ///< 0: A, 1: B
    glm::vec3 from{0}, to{0}, normal{0};  ///< ends on the sphere (equal: a full circle); outward normal of the face
    std::string label;             ///< the face, e.g. "A f7"
    std::string code;              ///< in, out, on+, on-, or empty
  };
  struct Mark {
    int solid = 0;
    glm::vec3 direction{0};
    std::string label;             ///< the edge, e.g. "A e3"
    std::string code;
  };
  std::vector<Arc> arcs;
  std::vector<Mark> marks;         ///< edges and intersections of arcs
};

/// One row of the inspector's table.
using Row = std::vector<std::string>;

struct Step {
  Phase phase = Phase::reduction;
  std::string kind;                ///< "contact", "segment", "neighborhood", "null edge", "cut", "part", "wedge", "result"
  std::string title;               ///< one line: "vertex v3 of A on face f7 of B"
  std::string words;               ///< what is decided here and by which rule (table and row), in sentences
  Row columns;
  std::vector<Row> table;          ///< codes before and after reclassification, …
  std::vector<glm::dvec3> places;  ///< one place, or the two ends of a segment
  std::string a, b;                ///< entities concerned, for break points ("v12")
  bool special = false;            ///< anything but an edge that crosses a face's interior
  SpherePicture sphere;            ///< empty if the step has none
};

/// What the pictures of a story show besides the step itself.
struct StoryView {
  bool eight_way = false;
  double exploded = 0;             ///< 0 … 1: parts, and the ends of null edges, pulled apart
  bool labels = false;
  bool dark = false;
};

class Story {
 public:
  /// Runs the operation with an observer; throws Cancelled, InternalError, … as boolean() does.
  static Story tell(const Solid& a, const Solid& b, Operation operation,
                    const std::atomic<bool>* cancel = nullptr);

  const std::vector<Step>& steps() const { return steps_; }
  /// First step of a phase and one past its last.
  std::pair<std::size_t, std::size_t> range(Phase phase) const;
  const Solid& result() const { return result_; }
  Operation operation() const { return operation_; }

  /// What to draw after `step` (all steps before it of the same phase are drawn too, fainter).
  /// Every phase has its own picture. Camera and surroundings are left to the caller.
  Picture picture(std::size_t step, const StoryView& view) const;

  /// The next (or previous) step that is special, or that a break point names; `step` if none.
  std::size_t next_special(std::size_t step, bool backwards) const;
  std::size_t next_of_kind(std::size_t step, const std::string& kind_or_entity) const;

 private:
  Solid a_, b_, result_;
  Operation operation_ = Operation::unite;
  std::vector<Step> steps_;
  struct Parts;
  std::shared_ptr<const Parts> parts_;
};

}  // namespace sectile::viewer
