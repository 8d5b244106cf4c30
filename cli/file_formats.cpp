#include "file_formats.h"

#include <algorithm>

namespace sectile::cli {
namespace {

// In the order of FileFormat, then the other names for the same.
const std::vector<std::string> names{"obj",        "stl-text", "stl-binary", "off", "ply-text",
                                     "ply-binary", "3mf",      "stl",        "ply"};

}  // namespace

const std::vector<std::string>& format_names() {
  return names;
}

FileFormat format_named(const std::string& name) {
  if (name == "stl") return FileFormat::stl_binary;
  if (name == "ply") return FileFormat::ply_text;
  return static_cast<FileFormat>(std::find(names.begin(), names.end(), name) - names.begin());
}

const std::string& name_of(FileFormat format) {
  return names[static_cast<std::size_t>(format)];
}

const std::string& name_of(LengthUnit unit) {
  // In the order of LengthUnit.
  static const std::vector<std::string> units{"micron", "millimeter", "centimeter",
                                              "inch",   "foot",       "meter"};
  return units[static_cast<std::size_t>(unit)];
}

}  // namespace sectile::cli
