// Faces of both solids around a common point or line, which meet there.
#pragma once

#include <vector>

#include "boolean/reduction/reduction.h"
#include "boolean/workspace.h"
#include "search/along_line.h"
#include "search/seen_arc.h"

namespace sectile {

/// Faces of one solid.
struct Fan {
  std::vector<FaceId> faces;
  std::vector<SeenArc> arcs;  ///< around a point, how it sees them
  std::vector<Box> boxes;     ///< around a line: of faces that meet off it, overlap
};

struct CommonFan {
  PerOperand<Fan> of;
  const AlongLine* line = nullptr;  ///< none: around a point
  std::vector<Vec3> places;         ///< the point, or several on the line, rounded
};

/// What the fan of one operand has in these places, vertices and edges between them, meets the
/// faces of the other one there: the pairs of loaded faces in which that is tested. Of what is in
/// one place, one is tested for all (Patch::tested). The first face of a pair is the operand's.
FacePairs pairs_of_owners(Workspace& w, Operand operand, const CommonFan& fan);

}  // namespace sectile
