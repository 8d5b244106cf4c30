#include "render/surfaces.h"

#include <algorithm>
#include <optional>

namespace sectile::viewer {
namespace {

// Peeling draws every translucent face twice for each layer. That is exact also where bodies
// interpenetrate, which is what this program is about; in motion large meshes cannot afford it.
constexpr GLsizei corners_to_peel_in_motion = 3 * 12000;
constexpr int layers_in_motion = 8;
constexpr int layers_at_rest = 24;

// Clipping by the section's plane, for as long as this lives.
class SectionClipping {
 public:
  explicit SectionClipping(const View& view) {
    if (view.picture.section.active) glEnable(GL_CLIP_DISTANCE0);
  }
  ~SectionClipping() { glDisable(GL_CLIP_DISTANCE0); }
  SectionClipping(const SectionClipping&) = delete;
  SectionClipping& operator=(const SectionClipping&) = delete;
};

// Coplanar faces of several surfaces would fight for the pixels: each surface lies a little in
// front of those before it, and those that yield behind all others.
double depth_shift(const View& view, std::size_t index) {
  const double count = static_cast<double>(view.picture.surfaces.size());
  const double each = std::min(4e-6, 2e-4 / count);
  const double behind = view.picture.surfaces[index].yields ? 1e-4 : 0;
  return (count - static_cast<double>(index)) * each + behind;
}

// In motion the back faces of closed surfaces are not drawn; only a section shows them.
class BackFaceCulling {
 public:
  BackFaceCulling(const View& view, const Surface& surface)
      : active_(view.is_fast() && !view.picture.section.active && surface.mesh->closed) {
    if (active_) glEnable(GL_CULL_FACE);
  }
  ~BackFaceCulling() {
    if (active_) glDisable(GL_CULL_FACE);
  }
  BackFaceCulling(const BackFaceCulling&) = delete;
  BackFaceCulling& operator=(const BackFaceCulling&) = delete;

 private:
  bool active_;
};

// Pushed back a little, as opaque faces are, so that edges and other lines on the faces win.
class PushedBack {
 public:
  explicit PushedBack(bool active) : active_(active) {
    if (!active_) return;
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.6f, 4.0f);
  }
  ~PushedBack() {
    if (active_) glDisable(GL_POLYGON_OFFSET_FILL);
  }
  PushedBack(const PushedBack&) = delete;
  PushedBack& operator=(const PushedBack&) = delete;

 private:
  bool active_;
};

bool mirrors(const glm::dmat4& model) {
  return glm::determinant(glm::dmat3(model)) < 0;
}

}  // namespace

SurfaceDrawer::SurfaceDrawer(MeshCache& meshes)
    : meshes_(meshes),
      shaded_("surface.vert", "surface.frag"),
      depth_only_("surface.vert", "nothing.frag"),
      mask_("surface.vert", "mask.frag"),
      peel_("surface.vert", "peel.frag"),
      peel_multisampled_("surface.vert", "peel.frag", "#define MULTISAMPLE\n") {}

bool SurfaceDrawer::is_drawn(const Surface& surface, Which which) const {
  if (!surface.mesh || !surface.faces) return false;
  if (surface.translucent) return which == (surface.yields ? Which::tints : Which::translucent);
  return which == (surface.is_tool ? Which::tools : Which::opaque);
}

void SurfaceDrawer::set_place(ShaderProgram& program, const View& view, const glm::dmat4& to_clip,
                              const Surface& surface, double shift) {
  program.set("model_to_clip", glm::mat4(to_clip * surface.model));
  program.set("kept_side", view.kept_side(surface.model));
  program.set("depth_shift", static_cast<float>(shift));
  glFrontFace(mirrors(surface.model) ? GL_CW : GL_CCW);
}

void SurfaceDrawer::set_look(ShaderProgram& program, const View& view, const Surface& surface) {
  const glm::vec3 colour = surface.highlighted
                               ? glm::mix(glm::vec3(surface.colour), glm::vec3(1), 0.18f)
                               : glm::vec3(surface.colour);
  program.set("colour", colour);
  program.set("normal_to_world",
              glm::mat3(glm::transpose(glm::inverse(glm::dmat3(surface.model)))));
  program.set("key_light", glm::vec3(view.key_light));
  // Of opaque faces alpha says what is outlined.
  program.set("alpha", surface.translucent ? surface.colour.a : surface.highlighted ? 1.0f : 0.0f);
  program.set("cut_open", view.picture.section.active && !surface.translucent ? 1 : 0);
  program.set("hatch_width", 7 * view.scale);
}

void SurfaceDrawer::draw_one(const Surface& surface) {
  const MeshBuffers& buffers = meshes_.buffers(surface.mesh);
  glBindVertexArray(buffers.triangles.id());
  glDrawArrays(GL_TRIANGLES, 0, buffers.corners);
  triangles_drawn_ += static_cast<std::uint64_t>(buffers.corners) / 3;
}

void SurfaceDrawer::draw_all(ShaderProgram& program, const View& view, Which which) {
  const SectionClipping clipping(view);
  const auto& surfaces = view.picture.surfaces;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (!is_drawn(surfaces[i], which)) continue;
    // What is removed is tinted at rest; in motion that would draw the largest meshes once more.
    if (which == Which::tints && view.is_fast() && is_dense(surfaces[i])) continue;
    std::optional<BackFaceCulling> culling;
    if (which == Which::opaque || which == Which::tools) culling.emplace(view, surfaces[i]);
    set_place(program, view, view.to_clip, surfaces[i], depth_shift(view, i));
    if (&program == &shaded_) set_look(program, view, surfaces[i]);
    const PushedBack pushed_back(which == Which::opaque || which == Which::tints);
    draw_one(surfaces[i]);
  }
}

void SurfaceDrawer::draw_opaque(const View& view) {
  shaded_.use();
  draw_all(shaded_, view, Which::opaque);
}

void SurfaceDrawer::draw_tools(const View& view) {
  shaded_.use();
  draw_all(shaded_, view, Which::tools);
}

void SurfaceDrawer::draw_tints(const View& view) {
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glEnable(GL_CULL_FACE);
  shaded_.use();
  draw_all(shaded_, view, Which::tints);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
}

bool SurfaceDrawer::is_dense(const Surface& surface) {
  return meshes_.buffers(surface.mesh).corners > corners_to_peel_in_motion;
}

void SurfaceDrawer::draw_casters(const View& view, const glm::dmat4& to_clip) {
  const SectionClipping clipping(view);
  depth_only_.use();
  for (const Surface& surface : view.picture.surfaces) {
    if (!is_drawn(surface, Which::opaque)) continue;
    set_place(depth_only_, view, to_clip, surface, 0);
    draw_one(surface);
  }
}

void SurfaceDrawer::add_translucent_depth(const View& view) {
  if (is_sorted(view)) return;
  const PushedBack pushed_back(true);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  depth_only_.use();
  draw_all(depth_only_, view, Which::translucent);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

GLsizei SurfaceDrawer::translucent_corners(const View& view) {
  GLsizei corners = 0;
  for (const Surface& surface : view.picture.surfaces)
    if (is_drawn(surface, Which::translucent)) corners += meshes_.buffers(surface.mesh).corners;
  return corners;
}

bool SurfaceDrawer::is_sorted(const View& view) {
  return view.is_fast() && translucent_corners(view) > corners_to_peel_in_motion;
}

void SurfaceDrawer::draw_translucent(const View& view, Targets& targets) {
  if (translucent_corners(view) == 0) return;
  if (is_sorted(view))
    draw_sorted(view);
  else
    peel(view, targets);
}

// From the farthest layer to the nearest. Each is found by a depth pass that keeps what lies in
// front of the layer before (at first: of the opaque faces), then blended over the picture where
// the depth is the one found.
void SurfaceDrawer::peel(const View& view, Targets& targets) {
  ShaderProgram& find = targets.is_multisampled() ? peel_multisampled_ : peel_;
  const int most = view.is_fast() ? layers_in_motion : layers_at_rest;
  for (int layer = 0; layer < most; ++layer) {
    targets.bind_layer(layer % 2);
    targets.bind_depth_texture(layer == 0 ? -1 : (layer + 1) % 2);
    glClearDepth(0);
    glClear(GL_DEPTH_BUFFER_BIT);
    glClearDepth(1);
    glDepthFunc(GL_GREATER);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    find.use();
    find.set("layer_before", 0);
    find.set("gap", layer == 0 ? 0.0f : 2e-7f);
    glBeginQuery(GL_ANY_SAMPLES_PASSED, any_pixel_.id());
    draw_all(find, view, Which::translucent);
    glEndQuery(GL_ANY_SAMPLES_PASSED);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    GLuint found = 0;
    glGetQueryObjectuiv(any_pixel_.id(), GL_QUERY_RESULT, &found);
    if (!found) break;

    glDepthFunc(GL_EQUAL);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    shaded_.use();
    draw_all(shaded_, view, Which::translucent);
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
  }
  glDepthFunc(GL_LESS);
  targets.bind_main();
}

// Surface by surface from far to near; of closed ones the front faces only, of others back faces
// before front faces. Exact for convex bodies that do not interpenetrate, close for others, and
// hardly dearer than opaque drawing.
void SurfaceDrawer::draw_sorted(const View& view) {
  struct Place {
    double depth;
    std::size_t index;
  };
  std::vector<Place> order;
  const auto& surfaces = view.picture.surfaces;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (!is_drawn(surfaces[i], Which::translucent)) continue;
    const glm::dvec4 centre =
        view.to_clip * surfaces[i].model * glm::dvec4(surfaces[i].mesh->bounds.centre(), 1);
    order.push_back({centre.z / centre.w, i});
  }
  std::stable_sort(order.begin(), order.end(),
                   [](const Place& a, const Place& b) { return a.depth > b.depth; });
  const SectionClipping clipping(view);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glEnable(GL_CULL_FACE);
  shaded_.use();
  for (const GLenum culled : {GL_FRONT, GL_BACK}) {
    glCullFace(culled);
    for (const Place& place : order) {
      const Surface& surface = surfaces[place.index];
      if (culled == GL_FRONT && surface.mesh->closed && !view.picture.section.active) continue;
      set_place(shaded_, view, view.to_clip, surface, depth_shift(view, place.index));
      set_look(shaded_, view, surface);
      draw_one(surface);
    }
  }
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
}

void SurfaceDrawer::draw_mask(const View& view, const Surface& surface, bool through) {
  const SectionClipping clipping(view);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  glDepthMask(GL_FALSE);
  glDepthFunc(through ? GL_ALWAYS : GL_LEQUAL);
  mask_.use();
  set_place(mask_, view, view.to_clip, surface, -1e-4);
  draw_one(surface);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace sectile::viewer
