// The sample scenes: the figures of the paper.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace sectile::viewer {

struct SampleTitle {
  std::string name, title, figure;
};

/// All samples in the order of the figures.
const std::vector<SampleTitle>& sample_titles();

/// The scene of a sample with its operation; throws std::out_of_range for an unknown name.
Scene sample_scene(const std::string& name);

}  // namespace sectile::viewer
