// Rows: all that runs along a crowded line (boolean/near/crowded_lines.h), edges of both operands
// and faces that lie on both sides of the line.
//
// A sweep along the line finds where each is to be divided (neighborhoods/row_sweep.h), and so what
// they share is in no segment.
#pragma once

#include "boolean/reduction/contact_table.h"

namespace sectile {

/// Moves what edges and faces share along crowded lines from the segments to rows, of lines that
/// have something of both operands. Adds places: those of all ends.
void make_rows(Workspace& w, const ContactTable& table, Contacts& found);

}  // namespace sectile
