// One step of a story: what one entity, place or segment went through in one phase.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sectile/trace.h"

namespace sectile::viewer {

/// The neighborhood of a contact as seen on the unit sphere around it: arcs of A and of B.
struct SpherePicture {
  /// Reaches counter-clockwise around `normal`; the arcs of each solid make closed cycles. Where
  /// the other solid's surface leaves the place, arcs are divided.
  struct Arc {
    int solid = 0;                        ///< 0: A, 1: B
    glm::vec3 from{0}, to{0}, normal{0};  ///< ends on the sphere (equal: a full circle); outward
                                          ///< normal of the face
    std::string label;                    ///< the face, e.g. "A f7"
    std::optional<TraceClass> cls;        ///< if known
  };
  struct Mark {
    int solid = 0;  ///< 0: an edge of A, 1: of B, -1: a contact segment of both leaves there
    glm::vec3 direction{0};
    std::string label;  ///< the edge, e.g. "A e3", or where the segment leads, e.g. "place 4"
    bool cut = false;   ///< of a contact segment
  };
  std::vector<Arc> arcs;
  std::vector<Mark> marks;
  bool is_empty() const { return arcs.empty(); }
};

/// One row of the inspector's table.
using Row = std::vector<std::string>;

/// What a step comes to, in three words; the tone is told by a colour too.
struct Verdict {
  enum class Tone : std::uint8_t { plain, special, cut, kept, dropped };
  std::string words;
  Tone tone = Tone::plain;
};

/// A table of the paper (with its errata mended), and what of it this step comes from.
struct PaperTable {
  std::string title;
  Row columns;
  std::vector<Row> rows;
  std::vector<std::size_t> lit_rows, lit_columns;  ///< no columns: all of them
};

/// A step as it stands in the time line.
struct StepRecord {
  Phase phase = Phase::reduction;
  std::uint32_t event = 0;  ///< number of its trace event
  bool special = false;     ///< anything but an edge that crosses a face's interior
};

/// A step in full.
struct Step {
  Phase phase = Phase::reduction;
  std::string kind;  ///< "contact", "segment", "neighborhood", "null edge", "cut", "part", "wedge",
                     ///< "result"
  std::string title;  ///< one line: "vertex v3 of A on face f7 of B"
  Verdict verdict;
  std::vector<std::string> bullets;  ///< at most three, short
  std::vector<PaperTable> paper;
  std::string words;  ///< what is decided here and by which rule (table and row), in sentences
  Row columns;
  std::vector<Row> table;          ///< codes before and after reclassification, …
  Row row_faces;                   ///< of each row: the face on the sphere ("A f3"), or nothing
  std::vector<glm::dvec3> places;  ///< one place, or the two ends of a segment, or none
  std::string a, b;                ///< entities concerned, for break points ("v12")
  bool special = false;
  SpherePicture sphere;  ///< empty if the step has none
};

}  // namespace sectile::viewer
