#include "scene/mesh_parts.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace sectile::viewer {

namespace {

const char* plural_of(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::micrometer:
      return "micrometres";
    case LengthUnit::millimeter:
      return "millimetres";
    case LengthUnit::centimeter:
      return "centimetres";
    case LengthUnit::inch:
      return "inches";
    case LengthUnit::foot:
      return "feet";
    case LengthUnit::meter:
      return "metres";
  }
  return "";
}

}  // namespace

double millimetres(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::micrometer:
      return 0.001;
    case LengthUnit::millimeter:
      return 1;
    case LengthUnit::centimeter:
      return 10;
    case LengthUnit::inch:
      return 25.4;
    case LengthUnit::foot:
      return 304.8;
    case LengthUnit::meter:
      return 1000;
  }
  return 1;
}

MeshParts read_parts(const std::filesystem::path& path) {
  MeshParts made;
  Model model = read_model(path);
  const std::string file = path.filename().string();
  if (model.unit != LengthUnit::millimeter) {
    char factor[32];
    std::snprintf(factor, sizeof factor, "%g", millimetres(model.unit));
    made.note =
        file + " counts in " + plural_of(model.unit) + ": scaled by " + factor + " to millimetres.";
  }
  const auto mixed = std::count_if(model.meshes.begin(), model.meshes.end(),
                                   [](const NamedMesh& mesh) { return mesh.has_more_colours; });
  if (mixed > 0) {
    made.note += made.note.empty() ? "" : " ";
    made.note += "Triangles of " + file +
                 " have colours of their own: each solid got the one that most of its have.";
  }
  for (NamedMesh& mesh : model.meshes) {
    MeshPart part;
    part.scale = millimetres(model.unit);
    part.name = mesh.name.empty() ? path.stem().string() : std::move(mesh.name);
    if (mesh.colour) {
      const auto& [red, green, blue] = *mesh.colour;
      part.colour = {red / 255.0f, green / 255.0f, blue / 255.0f};
    }
    part.mesh = std::make_shared<const PolygonMesh>(std::move(mesh.mesh));
    made.parts.push_back(std::move(part));
  }
  return made;
}

std::optional<MeshColour> in_bytes(const std::optional<NodeColour>& colour) {
  if (!colour) return std::nullopt;
  MeshColour bytes;
  for (std::size_t i = 0; i < 3; ++i)
    bytes[i] = static_cast<std::uint8_t>(std::lround(255 * std::clamp((*colour)[i], 0.0f, 1.0f)));
  return bytes;
}

}  // namespace sectile::viewer
