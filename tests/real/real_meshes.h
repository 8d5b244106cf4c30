// The meshes of Debian's packages libcgal-demo, assimp-testmodels and openscad-testing-data, if
// they are there: cmake/real_meshes.sh puts them into a folder.
#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace sectile::test {

/// In order; none if there is no such folder.
inline std::vector<std::string> real_meshes() {
  const char* named = std::getenv("SECTILE_REAL_MESHES");
  const std::filesystem::path folder = named ? named : SECTILE_REAL_MESHES;
  constexpr std::array<const char*, 5> formats{".off", ".obj", ".stl", ".ply", ".3mf"};
  std::vector<std::string> files;
  if (!std::filesystem::is_directory(folder)) return files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    std::string ending = entry.path().extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (entry.is_regular_file() &&
        std::find(formats.begin(), formats.end(), ending) != formats.end())
      files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace sectile::test
