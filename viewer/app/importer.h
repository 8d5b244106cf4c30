// Reads mesh files in the background and makes sure that they bound a solid before they come into
// the scene.
#pragma once

#include <filesystem>
#include <future>
#include <memory>
#include <string>
#include <vector>

#include "sectile/mesh.h"

namespace sectile::viewer {

class Importer {
 public:
  struct Outcome {
    std::filesystem::path path;
    std::shared_ptr<const PolygonMesh> mesh;  ///< null: see the error
    std::string error;
  };

  void start(const std::filesystem::path& path);
  /// Those that are finished. `wait`: all.
  std::vector<Outcome> take(bool wait);
  bool is_busy() const { return !running_.empty(); }

 private:
  std::vector<std::future<Outcome>> running_;
};

}  // namespace sectile::viewer
