#include "drawn_pictures.h"

#include "picture/surface_mesh.h"

namespace sectile::viewer {

Rgb at(const Image& image, int x, int y) {
  const std::size_t i = (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                         static_cast<std::size_t>(x)) *
                        4;
  return {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]};
}

Image drawn(Renderer& renderer, const Picture& picture) {
  renderer.begin_frame();
  renderer.draw(picture, {0, 0, width, height});
  return renderer.read_frame();
}

Image drawn(const Picture& picture) {
  const auto context = make_offscreen_context(width, height);
  Renderer renderer(*context);
  return drawn(renderer, picture);
}

Surface surface_of(const Solid& solid, const Colour& colour) {
  Surface surface;
  surface.mesh = surface_mesh(solid);
  surface.colour = colour;
  surface.translucent = colour.a < 1;
  surface.edges = false;
  return surface;
}

Picture plain_picture() {
  Picture picture;
  picture.surroundings.show_grid = picture.surroundings.show_axes = false;
  picture.surroundings.show_shadow = false;
  picture.surroundings.background_top = picture.surroundings.background_bottom = {1, 1, 1, 1};
  picture.camera.azimuth = 1.5707963;
  picture.camera.elevation = 0;
  picture.camera.distance = 10;
  return picture;
}

}  // namespace sectile::viewer
