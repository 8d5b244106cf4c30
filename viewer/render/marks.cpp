#include "render/marks.h"

#include <algorithm>
#include <cmath>

namespace sectile::viewer {
namespace {

// In motion, more edges than these are drawn as the machine's own thin lines.
constexpr GLsizei edge_ends_in_motion = 2 * 12000;
constexpr float edge_width = 1.5f;

// Whatever lies on a face is drawn in front of it by this much of the depth range.
constexpr float towards_camera = -2e-5f;

float smooth_step(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return static_cast<float>(t * t * (3 - 2 * t));
}

float strength_of(EdgePlace place, double crowding) {
  const float apart = 1 - smooth_step(0.2, 0.9, crowding);
  switch (place) {
    case EdgePlace::behind_faces:
      return 0.25f * apart;
    case EdgePlace::inside_translucent:
      return 0.32f * apart;
    case EdgePlace::in_front:
      break;
  }
  return apart;
}

// How much of a surface's place on the screen its edges would cover.
double crowding_of(const View& view, const Surface& surface, const EdgeBuffers& edges) {
  const Bounds& box = surface.mesh->bounds;
  const glm::dvec3 centre(surface.model * glm::dvec4(box.centre(), 1));
  const double growth = std::cbrt(std::abs(glm::determinant(glm::dmat3(surface.model))));
  const double pixel =
      std::max(1e-300, view.picture.camera.pixel_length(centre, view.size) * view.scale);
  const double radius = std::max(1.0, box.radius() * growth / pixel);
  return edges.length * growth / pixel * edge_width / (1.5 * radius * radius);
}

}  // namespace

MarkDrawer::MarkDrawer(MeshCache& meshes)
    : meshes_(meshes),
      segment_("segment.vert", "segment.frag"),
      hairline_("hairline.vert", "hairline.frag"),
      point_("point.vert", "point.frag") {}

void MarkDrawer::fill(std::vector<Pulled>& pool, std::size_t index,
                      const std::vector<glm::vec3>& places) {
  while (pool.size() <= index) pool.emplace_back();
  fill_pulled(pool[index].buffer, pool[index].texture, places, GL_STREAM_DRAW);
  pool[index].count = static_cast<GLsizei>(places.size());
}

void MarkDrawer::take(const View& view) {
  const Picture& picture = view.picture;
  for (std::size_t i = 0; i < picture.lines.size(); ++i) fill(lines_, i, picture.lines[i].ends);
  for (std::size_t i = 0; i < picture.points.size(); ++i)
    fill(points_, i, picture.points[i].places);
  GLsizei ends = 0;
  has_translucent_ = false;
  for (const Surface& surface : picture.surfaces) {
    if (!surface.mesh) continue;
    if (surface.edges) ends += meshes_.hard_edges(surface.mesh).count;
    if (surface.all_edges) ends += meshes_.smooth_edges(surface.mesh).count;
    has_translucent_ |= surface.translucent && surface.faces && !surface.yields;
  }
  hairlines_only_ = view.is_fast() && ends > edge_ends_in_motion;
}

void MarkDrawer::draw_hidden(const View& view) {
  glEnable(GL_BLEND);
  glDepthMask(GL_FALSE);
  // Behind opaque faces: what is to be seen through everything, and edges if they are asked for.
  glDepthFunc(GL_GREATER);
  if (view.picture.hidden_lines && !hairlines_only_) draw_edges(view, EdgePlace::behind_faces);
  draw_lines(view, 0, 0.35f);
  draw_points(view, true);
  // Inside translucent bodies; what lies in front of them is drawn again over this.
  if (has_translucent_) {
    glDepthFunc(GL_LEQUAL);
    if (!hairlines_only_) draw_edges(view, EdgePlace::inside_translucent);
    draw_lines(view, 0.6f, 0.6f);
    draw_points(view, true);
  }
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

void MarkDrawer::draw_visible(const View& view) {
  glEnable(GL_BLEND);
  glDepthMask(GL_FALSE);
  glDepthFunc(GL_LEQUAL);
  draw_edges(view, EdgePlace::in_front);
  draw_lines(view, 1, 1);
  draw_points(view, false);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

void MarkDrawer::draw_edges(const View& view, EdgePlace place) {
  for (const Surface& surface : view.picture.surfaces) {
    if (!surface.mesh || !surface.edges) continue;
    draw_edges(view, surface, meshes_.hard_edges(surface.mesh), place);
    if (surface.all_edges) draw_edges(view, surface, meshes_.smooth_edges(surface.mesh), place);
  }
}

void MarkDrawer::draw_edges(const View& view, const Surface& surface, const EdgeBuffers& edges,
                            EdgePlace place) {
  if (edges.count == 0) return;
  // Edges that crowd would only darken the picture; wires are all there is to see.
  float strength = strength_of(place, crowding_of(view, surface, edges));
  if (!surface.faces) strength = std::max(strength, place == EdgePlace::in_front ? 0.4f : 0.12f);
  if (strength < 0.04f) return;
  Stroke stroke{view.picture.surroundings.edge, edge_width, surface.model};
  if (!surface.faces) stroke.colour = glm::vec4(glm::vec3(surface.colour), 1);
  stroke.colour.a *= strength;
  if (hairlines_only_)
    draw_hairlines(view, edges, stroke);
  else
    draw_segments(view, edges.ends_texture.id(), edges.count, stroke);
}

void MarkDrawer::draw_lines(const View& view, float strength, float on_top_strength) {
  const auto& lines = view.picture.lines;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const float alpha = lines[i].on_top ? on_top_strength : strength;
    if (alpha <= 0) continue;
    Stroke stroke{lines[i].colour, lines[i].width, glm::dmat4(1)};
    stroke.colour.a *= alpha;
    draw_segments(view, lines_[i].texture.id(), lines_[i].count, stroke);
  }
}

void MarkDrawer::draw_points(const View& view, bool hidden) {
  point_.use();
  point_.set("places", 0);
  point_.set("to_clip", glm::mat4(view.to_clip));
  point_.set("kept_side", view.kept_side());
  point_.set("half_size", glm::vec2(view.size * 0.5));
  point_.set("depth_shift", 3 * towards_camera);
  point_.set("rim_width", 1.25f * view.scale);
  glBindVertexArray(nothing_.id());
  if (view.picture.section.active) glEnable(GL_CLIP_DISTANCE0);
  const auto& points = view.picture.points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points_[i].count == 0 || (hidden && !points[i].on_top)) continue;
    const glm::vec3 colour(points[i].colour);
    const bool is_dark = glm::dot(colour, glm::vec3(0.3f, 0.59f, 0.11f)) < 0.45f;
    const glm::vec3 rim = is_dark ? glm::vec3(1) : colour * 0.25f;
    point_.set("colour", glm::vec4(colour, points[i].colour.a * (hidden ? 0.45f : 1.0f)));
    point_.set("rim_colour", glm::vec4(rim, 1));
    point_.set("radius", 0.5f * points[i].size * view.scale);
    glBindTexture(GL_TEXTURE_BUFFER, points_[i].texture.id());
    glDrawArrays(GL_TRIANGLES, 0, points_[i].count * 6);
  }
  glDisable(GL_CLIP_DISTANCE0);
}

void MarkDrawer::draw_line(const View& view, const std::vector<glm::vec3>& ends,
                           const Colour& colour, float width) {
  fill(own_, 0, ends);
  glEnable(GL_BLEND);
  glDepthMask(GL_FALSE);
  draw_segments(view, own_[0].texture.id(), own_[0].count, {colour, width, glm::dmat4(1)});
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

void MarkDrawer::draw_segments(const View& view, GLuint texture, GLsizei ends,
                               const Stroke& stroke) {
  if (ends == 0) return;
  segment_.use();
  segment_.set("ends", 0);
  segment_.set("to_clip", glm::mat4(view.to_clip * stroke.model));
  segment_.set("kept_side", view.kept_side(stroke.model));
  segment_.set("half_size", glm::vec2(view.size * 0.5));
  segment_.set("half_width", 0.5f * stroke.width * view.scale);
  segment_.set("depth_shift", towards_camera);
  segment_.set("colour", stroke.colour);
  glBindVertexArray(nothing_.id());
  glBindTexture(GL_TEXTURE_BUFFER, texture);
  if (view.picture.section.active) glEnable(GL_CLIP_DISTANCE0);
  glDrawArrays(GL_TRIANGLES, 0, ends / 2 * 6);
  glDisable(GL_CLIP_DISTANCE0);
}

void MarkDrawer::draw_hairlines(const View& view, const EdgeBuffers& edges, const Stroke& stroke) {
  hairline_.use();
  hairline_.set("to_clip", glm::mat4(view.to_clip * stroke.model));
  hairline_.set("kept_side", view.kept_side(stroke.model));
  hairline_.set("depth_shift", towards_camera);
  hairline_.set("colour", stroke.colour);
  glBindVertexArray(edges.hairlines.id());
  if (view.picture.section.active) glEnable(GL_CLIP_DISTANCE0);
  glDrawArrays(GL_LINES, 0, edges.count);
  glDisable(GL_CLIP_DISTANCE0);
}

}  // namespace sectile::viewer
