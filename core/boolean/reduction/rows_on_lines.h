// Rows: all edges of both operands along a crowded line (boolean/near/crowded_lines.h).
//
// A sweep along the line finds where each is to be divided (neighborhoods/row_sweep.h), and so what
// they share is in no segment. That takes that nothing but edges runs along the line, that no face
// lies on both sides of it, and that none has two edges beside each other there: in a place where a
// face touches itself, all that it has there is divided.
#pragma once

#include "boolean/reduction/reduction.h"

namespace sectile {

/// Moves what edges share along crowded lines from the segments to rows, but for lines that no
/// sweep is for. Adds places: those of all ends.
void make_rows(Workspace& w, Contacts& found);

}  // namespace sectile
