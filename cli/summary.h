// What the program says of solids.
#pragma once

#include <string>

#include "sectile/sectile.h"

namespace sectile::cli {

struct Summary {
  SolidCounts counts;
  std::size_t triangles = 0, degenerate = 0;
  double volume = 0, area = 0;
};

/// Also counts the triangles of the export that rounding to doubles left without area.
Summary summarize(const Solid& solid, const PolygonMesh& mesh);

/// One line in words, or one JSON object.
std::string in_words(const std::string& name, const Summary& summary);
std::string in_json(const std::string& name, const Summary& summary);

}  // namespace sectile::cli
