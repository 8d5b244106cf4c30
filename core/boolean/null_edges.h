// Phases 2 to 4: the neighborhoods of all places where cuts end are split by null edges.
//
// A vertex with k cuts around it becomes k vertices at one point, one for each run of sectors
// between two cuts, in a chain of k - 1 null edges (paper, figures 9, 21 and 22). In the interior
// of a face the chain is an inner loop (figure 13).
#pragma once

#include "boolean/workspace.h"

namespace sectile {

/// Collects the ends of all cuts by the entity and place they end at.
void find_sites(Workspace& w);
/// Steps (1) to (3), (5), (6): subdivides the edges at the sites on them.
void subdivide_edges(Workspace& w);
/// Where a face touches itself at a place and several of its vertices there have cuts, null edges
/// link them so that each corner encloses nothing but a part of the face.
void bridge_touching_corners(Workspace& w);
/// Orders the cuts around each site counter-clockwise.
void order_cuts(Workspace& w);
/// Inserts the null edges.
void insert_null_edges(Workspace& w);

}  // namespace sectile
