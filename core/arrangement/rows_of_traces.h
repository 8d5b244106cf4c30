// Traces that lie on each other along one line, as where many faces meet in it.
#pragma once

#include <vector>

#include "arrangement/plane_pieces.h"

namespace sectile::arrangement {

/// Divides them where one of them begins or ends, into stretches that are there once: otherwise
/// each of n would meet all others. Traces that lie on few others stay as they are. Each has its
/// smaller end first.
void divide_rows(const Kernel& kernel, std::vector<Piece>& traces);

/// Takes out those on lines along which edges stay whole, and returns them, as one where they
/// overlap or touch.
std::vector<Piece> take_rows(const Kernel& kernel, std::vector<Piece>& traces);

}  // namespace sectile::arrangement
