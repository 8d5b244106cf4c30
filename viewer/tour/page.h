// The tour as one HTML page that needs nothing else.
#pragma once

#include <string>
#include <vector>

#include "tour/station.h"

namespace sectile::viewer {

/// What a station looks like in the modeller.
struct StationSight {
  std::string png;  ///< the bytes of the picture
  Step step;        ///< without a title where the phase has no steps
  std::vector<LegendKey> legend;
  struct Name {
    double x = 0, y = 0;  ///< shares of the picture's size, from the upper left
    std::string text;
    Colour colour{0, 0, 0, 1};
  };
  std::vector<Name> names;
};

/// One sight for each station, in their order.
std::string tour_page(const std::vector<Station>& stations,
                      const std::vector<StationSight>& sights);

}  // namespace sectile::viewer
