#include "demo_pictures.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "picture/surface_mesh.h"
#include "picture/theme.h"
#include "samples/samples.h"
#include "sectile/primitives.h"

namespace sectile::viewer {
namespace {

Surface surface_of(const Solid& solid, const Colour& colour, bool translucent = false) {
  Surface surface;
  surface.mesh = surface_mesh(solid);
  surface.colour = colour;
  surface.translucent = translucent;
  return surface;
}

Surface surface_of(const SurfacePart& part, const Colour& colour) {
  Surface surface;
  surface.mesh = surface_mesh(part);
  surface.colour = colour;
  return surface;
}

Picture framed(Picture picture, bool dark = false) {
  picture.surroundings = theme(dark).surroundings;
  picture.camera.look_at(picture.bounds(), 1.6);
  picture.camera.distance *= 1.15;
  return picture;
}

Picture two_blocks(bool dark) {
  const Theme& colours = theme(dark);
  Picture picture;
  picture.surfaces.push_back(surface_of(block({-1, -1, 0}, {1, 1, 2}), colours.a, true));
  picture.surfaces.push_back(surface_of(block({0, 0, 1}, {2, 2, 3}), colours.b, true));
  return framed(picture, dark);
}

Picture translucent_over_opaque() {
  const Theme& colours = theme(false);
  Picture picture;
  picture.surfaces.push_back(surface_of(sphere(0.7, 32, 16), colours.result));
  picture.surfaces[0].model = glm::translate(glm::dmat4(1), glm::dvec3(0, 0, 1));
  picture.surfaces.push_back(surface_of(block({-1, -1, 0}, {1, 1, 2}), colours.a, true));
  return framed(picture);
}

Picture section() {
  const Theme& colours = theme(false);
  Picture picture;
  picture.surfaces.push_back(
      surface_of(boolean(block({-1, -1, 0}, {1, 1, 2}), cylinder(0.5, 3, 48), Operation::subtract),
                 colours.a_out_b));
  picture.surfaces.push_back(surface_of(torus(1.8, 0.3, 48, 24), colours.b_out_a));
  picture.section = {true, {0.6, -0.8, 0, 0.1}};
  return framed(picture);
}

Picture selected() {
  const Theme& colours = theme(false);
  Picture picture;
  picture.surfaces.push_back(surface_of(torus(1, 0.35, 48, 24), colours.neutral));
  picture.surfaces.push_back(surface_of(block({0.5, 0.2, -0.5}, {2, 1.7, 0.5}), colours.neutral));
  picture.surfaces[0].highlighted = true;
  picture.surfaces.push_back(surface_of(wedge({-2.5, -2, 0}, {-1.5, -1, 1}), colours.neutral));
  picture.surfaces[2].faces = false;
  return framed(picture);
}

Picture marks() {
  const Theme& colours = theme(false);
  Picture picture = two_blocks(false);
  picture.lines.push_back({{{0, 0, 2}, {1, 0, 2}, {1, 0, 2}, {1, 1, 2}}, colours.cut, 4, true});
  picture.lines.push_back(
      {{{1, 1, 1}, {0, 1, 1}, {0, 1, 1}, {0, 0, 1}}, colours.null_edge, 4, false});
  picture.points.push_back(
      {{{0, 0, 2}, {1, 1, 2}, {1, 1, 1}, {0, 1, 1}}, colours.contact, 11, true});
  picture.points.push_back({{{2, 2, 3}, {-1, -1, 0}}, colours.coincident, 9, true});
  return picture;
}

Picture parts() {
  const Theme& colours = theme(false);
  const auto sample = samples::get("fig02");
  const FourWay four = classify(sample.a, sample.b, Operation::subtract);
  Picture picture;
  picture.surfaces.push_back(surface_of(four.a_in_b, colours.a_in_b));
  picture.surfaces.push_back(surface_of(four.a_out_b, colours.a_out_b));
  picture.surfaces.push_back(surface_of(four.b_in_a, colours.b_in_a));
  picture.surfaces.push_back(surface_of(four.b_out_a, colours.b_out_a));
  for (std::size_t i = 0; i < 4; ++i) {
    const double apart = i == 0 || i == 1 ? -0.6 : 0.6;
    picture.surfaces[i].model =
        glm::translate(glm::dmat4(1), glm::dvec3(apart * (i % 2 ? 2 : 1), 0, 0));
  }
  return framed(picture);
}

Picture flush_faces() {
  const Theme& colours = theme(false);
  Picture picture;
  picture.surfaces.push_back(surface_of(block({-2, -1, 0}, {0, 1, 2}), colours.a, true));
  picture.surfaces.push_back(surface_of(block({-1, -1, 0}, {1, 1, 1}), colours.b, true));
  return framed(picture);
}

}  // namespace

std::vector<DemoPicture> demo_pictures() {
  return {{"blocks", two_blocks(false)},
          {"blocks-dark", two_blocks(true)},
          {"translucent-over-opaque", translucent_over_opaque()},
          {"section", section()},
          {"selected", selected()},
          {"marks", marks()},
          {"parts", parts()},
          {"flush", flush_faces()}};
}

Picture dense_picture(std::size_t triangles, bool translucent, Quality quality) {
  const auto rings = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(triangles) / 4));
  Picture picture;
  picture.surfaces.push_back(
      surface_of(sphere(1, 2 * rings, rings + 1), theme(false).a, translucent));
  picture.quality = quality;
  return framed(picture);
}

}  // namespace sectile::viewer
