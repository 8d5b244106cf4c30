#include "render/embedded.h"

#include <stdexcept>
#include <string>

namespace sectile::viewer {
namespace {

struct File {
  std::string_view name, bytes;
};

// The bytes of a literal without the zero behind it.
template <std::size_t n>
constexpr std::string_view all_of(const char (&literal)[n]) {
  return {literal, n - 1};
}

// Pairs of a name and a literal that CMake makes of the file (cmake/EmbedFile.cmake).
constexpr File files[] = {
#include "embedded_files.inc"
};

}  // namespace

std::string_view embedded_file(std::string_view name) {
  for (const File& file : files)
    if (file.name == name) return file.bytes;
  throw std::out_of_range("no file " + std::string(name) + " in the program");
}

}  // namespace sectile::viewer
