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

/// The same, but what is found a pixel beside its place is no difference: `worst` is the mean over
/// that square of 8 pixels in which the two differ most. A mark that is missing is seen, and a part
/// in another colour; edges that another version of Mesa puts elsewhere by a fraction of a pixel
/// are not.
struct LocalDifference {
  double worst = 0;  ///< 0 … 1
  int x = 0, y = 0;  ///< the square's corner
  Image picture;     ///< as in ImageDifference
};
LocalDifference compare_locally(const Image& a, const Image& b);

}  // namespace sectile::viewer
