// Very many edges of both solids along one line, each with ends of its own, and maybe faces that
// lie on both sides of it: from end to end along the line, what changes around it?
//
// Between two neighbouring places all half-planes around the line could be sorted and paired, but
// at a place where one edge ends nearly all stays as it is. The class of a half-plane changes only
// where the other solid's boundary leads away from the line across it, and so meets its edge; its
// partner in a wedge of the result only where one of the two, or what lies between them, begins or
// ends to be kept. So a sweep keeps the half-planes that are present in their order around the
// line, and those that are kept; at each place it looks at the edges that end or meet something
// there, and at their neighbours. A class is what the nearest half-plane of the other solid says.
// Where there is none, the line may lie in that solid or outside: what begins there waits for one,
// and each edge bounds the wedge that it bounds in its solid.
//
// An edge, or a face, is divided where one of its sides changes, or meets something. Is that
// enough? Along a stretch where a side has one class, one partner, and meets nothing, neither has
// it a corner in the result, nor has its partner. Only its other side, or its partner's, may make
// an end of pieces there. In the result the pieces are one edge for each side: those behind the
// first one continue it (Wedges::continued). So pieces of two partners need not be the same, only
// where the pair begins and ends both have ends of pieces. If n edges of which each overlaps a few
// of the other solid all end elsewhere, there are so many times n pieces.
#pragma once

#include "boolean/neighborhoods/neighborhoods.h"

namespace sectile {

/// Adds what is found along a row, behind all segments.
void add_row(const Workspace& w, const Contacts& contacts, const Row& row, const Wanted& wanted,
             Neighborhoods& found);

}  // namespace sectile
