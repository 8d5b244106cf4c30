// Phase 3: the neighborhoods of all places where cuts end are split by null edges.
//
// A vertex with k cuts around it becomes k vertices at one point, one for each run of sectors
// between two cuts, in a chain of k - 1 null edges (paper, figures 9, 21 and 22). In the interior
// of a face the chain is an inner loop (figure 13).
#pragma once

#include <array>
#include <vector>

#include "boolean/null_edges/cut_plan.h"

namespace sectile {

struct NullEdge {
  Operand operand;
  EdgeId edge;
};

/// One end of a cut, in the patch.
struct CutEnd {
  SiteId site;
  SegmentId segment;
  CarrierId carrier;
  std::uint8_t which;  ///< at place[which] of its segment
  /// The chain of null half-edges to which the cut is attached, or (last invalid) the half-edge
  /// that follows the corner in which it leaves.
  HalfEdgeId first, last;
};

/// Where the cuts of a site end now.
struct SplitSite {
  Operand operand;
  Entity entity;
  PlaceId place;
  IdRange<CutEndId> ends;  ///< in counter-clockwise order
};

struct Cuts {
  Table<SiteId, SplitSite> sites;
  Table<CutEndId, CutEnd> ends;  ///< by site
  /// Of a carrier that is cut: its ends at place[0] and place[1].
  Table<CarrierId, std::array<CutEndId, 2>> of_carrier;
  std::vector<NullEdge> null_edges;
  /// The loaded faces in which null edges link corners that touch each other.
  PerOperand<std::vector<FaceId>> bridged;
};

/// Divides the edges at the sites on them, orders the cuts around each site and inserts the null
/// edges.
Cuts insert_null_edges(Workspace& w, const Contacts& contacts, const Neighborhoods& neighborhoods,
                       const CutPlan& plan);

}  // namespace sectile
