#include "viewer/reference_pictures.h"

#include <algorithm>
#include <sstream>

#include "render/image_difference.h"
#include "render/renderer.h"

namespace sectile::viewer {
namespace {

std::filesystem::path write_new(const std::string& name, const Image& image) {
  std::filesystem::create_directories(new_pictures_folder());
  const std::filesystem::path path = new_pictures_folder() / (name + ".png");
  write_png(path.string(), image);
  return path;
}

}  // namespace

std::filesystem::path reference_folder() {
  return SECTILE_REFERENCE_FOLDER;
}

std::filesystem::path new_pictures_folder() {
  return SECTILE_NEW_PICTURES_FOLDER;
}

std::string difference_from_reference(const std::string& name, const Image& image) {
  const std::filesystem::path kept = reference_folder() / (name + ".png");
  std::filesystem::remove(new_pictures_folder() / (name + ".png"));
  std::filesystem::remove(new_pictures_folder() / (name + "-difference.png"));
  if (!std::filesystem::exists(kept))
    return "there is no " + kept.string() + "; the new picture is " +
           write_new(name, image).string();
  const LocalDifference difference = compare_locally(read_png(kept.string()), image);
  if (difference.worst <= tolerated_difference) return {};
  std::ostringstream text;
  text << kept.string() << " differs by " << difference.worst << " at " << difference.x << ','
       << difference.y << "; the new picture is " << write_new(name, image).string();
  if (!difference.picture.rgba.empty())
    text << " and what differs is red in "
         << write_new(name + "-difference", difference.picture).string();
  return text.str();
}

std::vector<std::string> reference_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(reference_folder()))
    if (entry.path().extension() == ".png") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace sectile::viewer
