#include "app/importer.h"

#include <chrono>

#include "sectile/sectile.h"

namespace sectile::viewer {
namespace {

Importer::Outcome read(const std::filesystem::path& path) {
  try {
    auto mesh = std::make_shared<const PolygonMesh>(read_mesh(path));
    if (Solid::from_mesh(*mesh).is_empty())
      return {path, nullptr, path.filename().string() + " holds no solid: it has no faces."};
    return {path, std::move(mesh), {}};
  } catch (const InvalidSolid& error) {
    return {path, nullptr,
            path.filename().string() + " is not a closed solid: " + error.what() +
                " Mend the mesh where it was made, then open it again."};
  } catch (const std::exception& error) {
    return {path, nullptr, error.what()};
  }
}

}  // namespace

void Importer::start(const std::filesystem::path& path) {
  running_.push_back(std::async(std::launch::async, read, path));
}

std::vector<Importer::Outcome> Importer::take(bool wait) {
  std::vector<Outcome> finished;
  for (auto it = running_.begin(); it != running_.end();) {
    if (!wait && it->wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
      ++it;
      continue;
    }
    finished.push_back(it->get());
    it = running_.erase(it);
  }
  return finished;
}

}  // namespace sectile::viewer
