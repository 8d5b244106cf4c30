// What the picture shows of a mesh that is being repaired.
#include "app/repair_bench.h"

namespace sectile::viewer {
namespace {

// More numbers would hide the mesh, and each other.
constexpr std::size_t most_numbers = 40;

void add_surface(Picture& picture, const std::shared_ptr<const SurfaceMesh>& mesh,
                 const Colour& colour) {
  if (!mesh || mesh->positions.empty()) return;
  Surface surface;
  surface.mesh = mesh;
  surface.colour = with_alpha(colour, 1);
  picture.surfaces.push_back(std::move(surface));
}

void add_marks(Picture& picture, const MeshDefects& defects, int lit, const Theme& colours) {
  Points places{{}, colours.step, 9, true};
  for (std::size_t i = 0; i < defects.list.size(); ++i) {
    const MeshDefect& defect = defects.list[i];
    if (!defect.place) continue;
    places.places.emplace_back(*defect.place);
    if (static_cast<int>(i) == lit)
      picture.labels.push_back(
          {*defect.place, std::to_string(i + 1) + ": " + defect.text, colours.text, true});
    else if (i < most_numbers)
      picture.labels.push_back({*defect.place, std::to_string(i + 1), colours.text, false});
  }
  if (!places.places.empty()) picture.points.push_back(std::move(places));
}

void add_lines(Picture& picture, const std::vector<glm::vec3>& ends, const Colour& colour,
               float width, const char* text) {
  if (ends.empty()) return;
  picture.lines.push_back({ends, with_alpha(colour, 1), width, true});
  picture.legend.push_back({text, with_alpha(colour, 1), LegendKey::Form::line});
}

void add_defects(Picture& picture, const MeshDefects& defects, int lit, const Theme& colours) {
  add_surface(picture, defects.sound, colours.neutral);
  add_surface(picture, defects.touching, colours.b);
  if (defects.touching && !defects.touching->positions.empty())
    picture.legend.push_back(
        {"faces that cross or lie on others", with_alpha(colours.b, 1), LegendKey::Form::area});
  add_lines(picture, defects.borders, colours.a, 3, "borders of holes");
  add_lines(picture, defects.contradictions, colours.null_edge, 3,
            "edges along which faces contradict each other");
  if (lit >= 0 && static_cast<std::size_t>(lit) < defects.list.size())
    add_lines(picture, defects.list[static_cast<std::size_t>(lit)].edges, colours.step, 5,
              "the line chosen");
  add_marks(picture, defects, lit, colours);
}

}  // namespace

Picture picture_of(const RepairBench& bench, const Theme& colours) {
  Picture picture;
  if (bench.shows_after && bench.preview())
    add_surface(picture, bench.preview()->surface, colours.result);
  else if (bench.defects())
    add_defects(picture, *bench.defects(), bench.lit, colours);
  return picture;
}

}  // namespace sectile::viewer
