#include "app/settings_file.h"

#include <array>
#include <fstream>
#include <string>
#include <utility>

#include "sectile/files.h"

namespace sectile::viewer {
namespace {

constexpr std::array<std::pair<const char*, bool ViewSettings::*>, 4> kept{{
    {"dark", &ViewSettings::dark},
    {"grid", &ViewSettings::grid},
    {"axes", &ViewSettings::axes},
    {"hints", &ViewSettings::hints},
}};

}  // namespace

void load_settings(const std::filesystem::path& path, ViewSettings& settings) {
  std::ifstream in(path);
  std::string name;
  bool value = false;
  while (in >> name >> value)
    for (const auto& [known, setting] : kept)
      if (name == known) settings.*setting = value;
}

void save_settings(const std::filesystem::path& path, const ViewSettings& settings) {
  std::string text;
  for (const auto& [name, setting] : kept)
    text += std::string(name) + (settings.*setting ? " 1\n" : " 0\n");
  std::filesystem::create_directories(path.parent_path());
  write_whole(path, text);
}

}  // namespace sectile::viewer
