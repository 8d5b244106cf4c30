// What runs along a crowded line: edges, and faces that lie on both sides of it.
#pragma once

#include <compare>
#include <cstdint>
#include <utility>
#include <vector>

#include "boolean/line.h"
#include "boolean/reduction/face_stretches.h"

namespace sectile {

/// An edge, or a stretch in a face. The face of a half-space has all of the line: no points.
struct OnLine {
  Operand operand;
  Entity carrier;
  FaceStretch end;           ///< of an edge in any order
  std::vector<PlaceId> met;  ///< between its ends: where segments end that lead away from the line
};

/// Where a segment in a face crosses the line, or another line leads away from an edge or a face on
/// this one, and nothing is known to divide it.
struct Crossed {
  Operand operand;
  Entity carrier;
  PointId point;
};

/// What of both operands is on one of Workspace::crowded_lines.
struct LineOfBoth {
  std::vector<OnLine> all;  ///< edges before faces
  std::vector<Crossed> crossed;
  bool is_swept = false;  ///< is it a row?

  bool has_edges() const { return !all.empty() && all.front().carrier.is_edge(); }
};
using LinesOfBoth = std::vector<LineOfBoth>;

/// A face of an operand that lies on both sides of a line.
struct FaceOnLine {
  Operand operand;
  FaceId face;
  std::uint32_t line;
  friend auto operator<=>(const FaceOnLine&, const FaceOnLine&) = default;
};

inline AlongLineOfPoints along_line(const Workspace& w, std::uint32_t line) {
  const auto& [p, q] = w.crowded_lines[line];
  return {w.tests(), p, q};
}
/// Two planes that meet in a line that has edges.
inline std::pair<PlaneId, PlaneId> planes_through(const Workspace& w, const LineOfBoth& line) {
  const OnLine& edge = line.all.front();
  return line_planes(w.patch[edge.operand], Brep::half_edge(edge.carrier.edge()));
}
/// One of them that is not parallel to a face that has the line in its plane.
inline PlaneId plane_across(const Workspace& w, const LineOfBoth& line, Operand s, FaceId face) {
  const auto [a, b] = planes_through(w, line);
  return w.tests().parallel(w.patch[s].plane(face), a) ? b : a;
}

}  // namespace sectile
