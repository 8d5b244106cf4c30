// Points through which very many edges of both solids run, each in a direction of its own
// (search/crossing_fans.h).
//
// Faces that meet in nothing but such a point, which is within edges of both or a corner, are in no
// pair: no segment ends there for them. Those that meet in more are, so that the edges between them
// are cut in the point.
#pragma once

#include <vector>

#include "boolean/reduction/reduction.h"
#include "boolean/workspace.h"

namespace sectile {

class CrowdedCrossings {
 public:
  bool empty() const { return crossings_.empty(); }
  /// A point of a geometry, and all faces of both solids that have it in an edge or a corner.
  void add(const Geometry& geometry, PointId point, PerOperand<std::vector<FaceId>> faces);

  /// They have to be loaded, whether they are in pairs or not.
  PerOperand<std::vector<FaceId>> faces() const;
  /// Adds the points to the workspace.
  void mark(Workspace& w) const;
  /// The edges and vertices that two faces of a pair have at a point are tested by their owners:
  /// adds these pairs of loaded faces.
  void add_pairs_of_owners(const Workspace& w, FacePairs& pairs) const;

 private:
  struct Crossing {
    PointId point;
    PerOperand<std::vector<FaceId>> faces;
  };

  Geometry geometry_;
  std::vector<Crossing> crossings_;
};

}  // namespace sectile
