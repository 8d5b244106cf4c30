// Points of a shell that are not on the other boundary.
#pragma once

#include <initializer_list>
#include <vector>

#include "boolean/reduction/reduction.h"
#include "sectile/errors.h"

namespace sectile {

/// Walks over the loaded faces of one operand, over each once.
class FreePoints {
 public:
  FreePoints(Workspace& w, const Contacts& contacts, Operand operand);

  /// One or a few of the shell to which a loaded face belongs. Adds points, maybe planes, to the
  /// geometry. May throw NeedsAllPairs: all edges of the shell are on crowded lines then, and none
  /// of its faces is known to have doubles within it, and no contact.
  std::vector<PointId> on_shell_of(FaceId face);
  /// One within a face of the last shell that was asked for, along which rays in x do not run; or
  /// none.
  PointId facing_x();

 private:
  void add_crowded_lines();
  void add_crowded_points();
  bool is_crowded_point(PointId point) const;
  bool is_where_pairs_were_left_out(PointId point) const;
  bool are_on_crowded_line(std::initializer_list<PointId> points) const;
  PointId corner_beyond(HalfEdgeId in_solid);
  bool visit_next();
  PointId within_an_edge(std::vector<EdgeId>& edges);
  PointId within_a_face();
  PointId within(FaceId face, double part);

  Workspace& w_;
  Operand operand_;
  const Patch& patch_;
  const Brep& brep_;
  std::vector<FaceId> faces_, front_;  // of the last shell: visited, and to be visited
  Table<FaceId, std::uint8_t> seen_;
  Table<VertexId, std::uint8_t> vertex_in_contact_;
  Table<EdgeId, std::uint8_t> edge_in_contact_;
  Table<FaceId, std::uint8_t> face_in_contact_;
};

}  // namespace sectile
