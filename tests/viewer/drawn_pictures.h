// Small pictures drawn off screen, and their pixels.
#pragma once

#include "picture/picture.h"
#include "render/renderer.h"
#include "sectile/solid.h"

namespace sectile::viewer {

constexpr int width = 320, height = 240;

struct Rgb {
  int r, g, b;
};
Rgb at(const Image& image, int x, int y);

Image drawn(Renderer& renderer, const Picture& picture);
Image drawn(const Picture& picture);  ///< by a renderer of its own

/// Without edges.
Surface surface_of(const Solid& solid, const Colour& colour);

/// Looks along -y at the origin; nothing but the solids on white.
Picture plain_picture();

}  // namespace sectile::viewer
