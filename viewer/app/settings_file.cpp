#include "app/settings_file.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <string>
#include <utility>

#include "sectile/files.h"

namespace sectile::viewer {
namespace {

constexpr std::array<std::pair<const char*, bool ViewSettings::*>, 5> kept{{
    {"dark", &ViewSettings::dark},
    {"grid", &ViewSettings::grid},
    {"axes", &ViewSettings::axes},
    {"hints", &ViewSettings::hints},
    {"cube", &ViewSettings::cube},
}};

constexpr std::array<std::pair<const char*, double ViewSettings::*>, 4> kept_sizes{{
    {"left_model", &ViewSettings::left_model},
    {"left_steps", &ViewSettings::left_steps},
    {"right_steps", &ViewSettings::right_steps},
    {"sphere", &ViewSettings::sphere},
}};

}  // namespace

void load_settings(const std::filesystem::path& path, ViewSettings& settings,
                   std::filesystem::path& folder) {
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    const std::size_t blank = line.find(' ');
    if (blank == std::string::npos) continue;
    const std::string name = line.substr(0, blank), value = line.substr(blank + 1);
    for (const auto& [known, setting] : kept)
      if (name == known && (value == "0" || value == "1")) settings.*setting = value == "1";
    for (const auto& [known, setting] : kept_sizes)
      if (name == known) settings.*setting = std::clamp(std::atof(value.c_str()), 0.0, 4000.0);
    std::error_code error;
    if (name == "folder" && std::filesystem::is_directory(value, error)) folder = value;
  }
}

void save_settings(const std::filesystem::path& path, const ViewSettings& settings,
                   const std::filesystem::path& folder) {
  std::string text;
  for (const auto& [name, setting] : kept)
    text += std::string(name) + (settings.*setting ? " 1\n" : " 0\n");
  for (const auto& [name, setting] : kept_sizes)
    text += std::string(name) + " " + std::to_string(settings.*setting) + "\n";
  // A name with a line break would be two lines.
  if (!folder.empty() && folder.string().find('\n') == std::string::npos)
    text += "folder " + folder.string() + "\n";
  std::filesystem::create_directories(path.parent_path());
  write_whole(path, text);
}

}  // namespace sectile::viewer
