// What is to be drawn, as plain data. The renderer draws pictures and knows nothing of solids; all
// others make pictures and know nothing of OpenGL.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "picture/camera.h"

namespace sectile::viewer {

/// RGBA as style sheets have it (the screen's values), not premultiplied.
using Colour = glm::vec4;

/// The triangles and edges of a surface. Immutable once shared; the renderer keeps its buffers as
/// long as someone holds the mesh.
struct SurfaceMesh {
  std::vector<glm::vec3> positions;     ///< three for each triangle
  std::vector<glm::vec3> normals;       ///< one for each position; equal across smooth edges
  std::vector<glm::vec3> hard_edges;    ///< two for each edge where the surface bends sharply
  std::vector<glm::vec3> smooth_edges;  ///< two for each of the others: drawn as wires only
  std::vector<std::uint32_t> faces;     ///< one for each triangle: the solid's face (for picking)
  Bounds bounds;
  bool closed = false;  ///< without a boundary: its back faces are seen in a section only
};

/// A surface placed in the world.
struct Surface {
  std::shared_ptr<const SurfaceMesh> mesh;
  glm::dmat4 model{1};
  Colour colour{0.7f, 0.7f, 0.7f, 1};
  bool translucent =
      false;               ///< drawn with colour.a, sorted correctly against other translucent ones
  bool edges = true;       ///< hard edges
  bool faces = true;       ///< false: edges in the surface's colour instead
  bool all_edges = false;  ///< smooth edges too
  bool silhouette = false;   ///< outlined thinly in its colour where nothing hides it
  bool highlighted = false;  ///< outlined (selection or hover), whatever hides it
  bool yields = false;       ///< hidden by opaque surfaces that lie in the same place
  bool is_tool = false;      ///< a handle: casts no shadow and darkens no corner
  bool operator==(const Surface&) const = default;
};

/// Line segments of one colour and width (pixels at 100 % scale).
struct Lines {
  std::vector<glm::vec3> ends;  ///< two for each segment
  Colour colour{0, 0, 0, 1};
  float width = 2;
  bool on_top = false;  ///< also seen through surfaces, dimmed there
  bool operator==(const Lines&) const = default;
};

/// Round marks of one colour and size (pixels at 100 % scale).
struct Points {
  std::vector<glm::vec3> places;
  Colour colour{0, 0, 0, 1};
  float size = 8;
  bool on_top = true;
  bool operator==(const Points&) const = default;
};

/// A text at a place in the world, drawn over the picture.
struct Label {
  glm::dvec3 place{0};
  std::string text;
  Colour colour{0, 0, 0, 1};
  bool plate = false;  ///< on a plate of its own, to be read over anything
  bool operator==(const Label&) const = default;
};

/// What a colour in the picture means.
struct LegendKey {
  enum class Form : std::uint8_t { area, line, point };
  std::string text;
  Colour colour{0, 0, 0, 1};
  Form form = Form::area;
  bool operator==(const LegendKey&) const = default;
};

/// Cuts away what lies on the positive side of n·p + d = 0.
struct SectionPlane {
  bool active = false;
  glm::dvec4 plane{1, 0, 0, 0};
  bool operator==(const SectionPlane&) const = default;
};

/// Colours of the surroundings; see theme.h.
struct Surroundings {
  Colour background_top{0.93f, 0.95f, 0.97f, 1}, background_bottom{0.80f, 0.84f, 0.88f, 1};
  Colour grid{0.55f, 0.58f, 0.62f, 0.55f};
  Colour edge{0.10f, 0.11f, 0.13f, 1};
  Colour outline{0.94f, 0.19f, 0.61f, 1};  ///< around highlighted surfaces
  Colour axis_x{0.84f, 0.25f, 0.35f, 1}, axis_y{0.31f, 0.62f, 0.21f, 1},
      axis_z{0.23f, 0.47f, 0.88f, 1};
  bool show_grid = true, show_axes = true;
  bool show_shadow = true;  ///< of opaque surfaces on the ground, at rest
  double grid_step = 1;
  bool operator==(const Surroundings&) const = default;
};

/// How much care a frame takes: while something moves, less. In full, edges are smooth, corners
/// and hollows darker, and there is a soft shadow on the ground.
enum class Quality : std::uint8_t { fast, full };

struct Picture {
  Camera camera;
  std::vector<Surface> surfaces;
  std::vector<Lines> lines;
  std::vector<Points> points;
  std::vector<Label> labels;      ///< drawn by the user interface layer, as is the legend:
  std::vector<LegendKey> legend;  ///< every colour that means something here, and no other
  SectionPlane section;
  Surroundings surroundings;
  Quality quality = Quality::full;
  bool hidden_lines = false;  ///< edges behind faces are drawn too, faintly

  Bounds bounds() const;  ///< of surfaces, lines and points
  bool operator==(const Picture&) const = default;
};

}  // namespace sectile::viewer
