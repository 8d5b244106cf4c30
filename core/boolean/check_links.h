// The links of both patches, checked after a phase if the options ask for it.
#pragma once

#include "boolean/workspace.h"

namespace sectile {

/// Throws InternalError if they are broken.
void check_links(const Workspace& w, const char* after);

}  // namespace sectile
