// How different two pictures look. Both are blurred a little first, so that the last bits of edges
// do not count.
#pragma once

#include "render/graphics_context.h"

namespace sectile::viewer {

struct ImageDifference {
  double mean = 0;   ///< of the colour differences of all pixels, 0 … 1
  double share = 0;  ///< of the pixels that differ by more than the threshold, 0 … 1
  Image picture;     ///< grey where equal, red where not; empty if the sizes differ
};

/// Pictures of different sizes differ wholly (mean and share are 1).
ImageDifference compare_images(const Image& a, const Image& b, double threshold = 0.06);

}  // namespace sectile::viewer
