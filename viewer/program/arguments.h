// The command line of sectile-viewer.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/recording.h"
#include "picture/camera.h"
#include "sectile/sectile.h"

namespace sectile::viewer {

/// As in `sectile`: 0 done, 1 an input is not a legal solid, 2 wrong usage, 3 a file cannot be read
/// or written, 4 internal error.
enum class ExitCode { done = 0, not_legal = 1, usage = 2, file = 3, internal = 4 };

/// Where the camera is to be; without a target it looks at what there is.
struct CameraWish {
  double azimuth = 0, elevation = 0;  ///< degrees
  double distance = 0;                ///< 0: everything in view
  std::optional<glm::dvec3> target;

  /// `camera` as wished; what is not said comes from `all`, the bounds of what is shown.
  Camera applied_to(Camera camera, const Bounds& all, double aspect) const;
};

struct Arguments {
  std::vector<std::filesystem::path> files;
  std::filesystem::path scene;
  std::string sample;
  std::optional<Phase> phase;
  std::size_t step = 0;  ///< of the phase, from 1; 0: its last
  std::optional<CameraWish> camera;
  int width = 1280, height = 800;  ///< pixels of a screenshot, units of a window
  float scale = 0;                 ///< 0: the screen's, 1 without a screen
  bool dark = false, interface = true;
  std::optional<Operation> operation;
  double exploded = 0;
  bool eight_way = false;
  std::filesystem::path screenshot;
  std::optional<RecordingPlan> film;  ///< without its size
  std::filesystem::path tour;         ///< a folder to write the tour of the paper into

  /// A picture of a story without interface: needs no modeller.
  bool is_story_picture() const;
};

/// What to do, or with what to exit at once (help and wrong usage were already told).
std::variant<Arguments, ExitCode> parse_arguments(int argc, char** argv);

}  // namespace sectile::viewer
