// Solids may have planes in common: those of what was cut by one tool, or comes from one solid.
// Their tests need no arithmetic if they are one plane.
#pragma once

#include "boolean/reduction/reduction.h"

namespace sectile {

/// Makes planes with equal definitions one in both patches, before these are completed, if any pair
/// of faces shows that there are such planes. Those whose doubles are exact are left as they are:
/// tests with them take no time.
void unite_equal_planes(Workspace& w, const FacePairs& pairs);

}  // namespace sectile
