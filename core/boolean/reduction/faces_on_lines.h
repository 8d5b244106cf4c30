// Which faces lie on both sides of crowded lines.
#pragma once

#include <vector>

#include "boolean/reduction/contact_table.h"
#include "boolean/reduction/on_line.h"

namespace sectile {

/// Those that may matter, ascending: that have corners on a line, or edges of the other operand in
/// them there, or meet such ones along it. The lines have their edges.
std::vector<FaceOnLine> faces_on_lines(const Workspace& w, const ContactTable& table,
                                       const Contacts& found, const LinesOfBoth& lines);

}  // namespace sectile
