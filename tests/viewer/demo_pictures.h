// Pictures that show what the renderer has to do well.
#pragma once

#include <string>
#include <vector>

#include "picture/picture.h"

namespace sectile::viewer {

struct DemoPicture {
  std::string name;
  Picture picture;
};

std::vector<DemoPicture> demo_pictures();

/// A sphere of about so many triangles, in the camera's view.
Picture dense_picture(std::size_t triangles, bool translucent, Quality quality);

}  // namespace sectile::viewer
