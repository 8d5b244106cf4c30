// What is wrong with a solid that should be a given set of cells.
#pragma once

#include <functional>
#include <string>
#include <utility>

#include "boundary.h"
#include "sectile/solid.h"

namespace sectile::test {

/// Empty if the solid is legal (with `geometry`, its faces are also tested against each other),
/// has exactly the volume and, up to the rounding of square roots, the area, contains exactly the
/// cells of the set, and has as many shells and handles as wedges of material on their own give.
std::string fault(const Solid& solid, const Complex& complex, Mask wanted, bool geometry);

/// Empty if the triangles are closed: over each directed edge as often one way as the other.
std::string fault_of_closure(const PolygonMesh& mesh);

/// Takes cells out of both sets for as long as `fails(a, b)` remains true.
std::pair<Mask, Mask> shrunk(Mask a, Mask b, const std::function<bool(Mask, Mask)>& fails);

}  // namespace sectile::test
