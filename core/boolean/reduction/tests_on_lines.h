// Who tests what is on crowded lines (boolean/near/crowded_lines.h)?
//
// Elsewhere one face speaks for each vertex and edge, as its pairs are those of all faces there.
// On crowded lines pairs are left out: that of the speaker may be one of them. There the first
// face that has a vertex or edge, and is in a pair with a face of the other solid, tests it
// against that face.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "boolean/reduction/reduction.h"

namespace sectile {

class TestsOnLines {
 public:
  TestsOnLines(const Workspace& w, const FacePairs& candidates);

  /// Is the start of a half-edge, or the edge, tested in this way?
  bool has_vertex(Operand s, VertexId v) const { return any_ && w_.patch[s].on_crowded_line[v]; }
  bool has_edge(Operand s, HalfEdgeId h) const {
    const Brep& brep = w_.patch[s].brep;
    return has_vertex(s, brep.from(h)) && has_vertex(s, brep.to(h));
  }
  /// Is it to be tested for this half-edge of a face of a pair?
  bool vertex_is_tested(Operand s, std::size_t pair, HalfEdgeId h) const {
    return contains(vertices_[s], pair, h);
  }
  bool edge_is_tested(Operand s, std::size_t pair, HalfEdgeId h) const {
    return contains(edges_[s], pair, h);
  }

 private:
  struct Test {
    std::uint32_t pair;
    HalfEdgeId h;
    friend auto operator<=>(const Test&, const Test&) = default;
  };
  static bool contains(const std::vector<Test>& tests, std::size_t pair, HalfEdgeId h);
  void find(Operand s, const FacePairs& candidates);

  const Workspace& w_;
  bool any_;
  PerOperand<std::vector<Test>> vertices_, edges_;  // ascending
};

}  // namespace sectile
