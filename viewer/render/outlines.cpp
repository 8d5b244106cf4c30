#include "render/outlines.h"

#include <algorithm>
#include <cmath>

namespace sectile::viewer {
namespace {

constexpr float thick = 3.5f, thin = 1.7f;  // pixels at 100 % scale

// The pixels, from the lower left, that a box may cover.
struct Part {
  int x = 0, y = 0, width = 0, height = 0;
  bool is_empty() const { return width <= 0 || height <= 0; }
};

// Not at the sides of the picture: nothing lies beyond.
Part shrunk(const Part& part, int by, const Targets& targets) {
  const int left = part.x == 0 ? 0 : by, bottom = part.y == 0 ? 0 : by;
  const int right = part.x + part.width == targets.width() ? 0 : by;
  const int top = part.y + part.height == targets.height() ? 0 : by;
  return {part.x + left, part.y + bottom, std::max(0, part.width - left - right),
          std::max(0, part.height - bottom - top)};
}

class PartFinder {
 public:
  PartFinder(const View& view, const Targets& targets) : view_(view), targets_(targets) {}

  void add(const Surface& surface) {
    const Bounds& box = surface.mesh->bounds;
    if (box.is_empty()) return;
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec3 p(corner & 1 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y,
                         corner & 4 ? box.high.z : box.low.z);
      const glm::dvec4 clip = view_.to_clip * (surface.model * glm::dvec4(p, 1));
      // What reaches behind the eye may be anywhere.
      if (clip.w <= 0) everywhere_ = true;
      const glm::dvec2 place = glm::dvec2(clip) / clip.w;
      low_ = glm::min(low_, place);
      high_ = glm::max(high_, place);
    }
  }

  Part found(float margin) const {
    const int width = targets_.width(), height = targets_.height();
    if (everywhere_) return {0, 0, width, height};
    const auto pixel = [&](double ndc, int size, double by) {
      return static_cast<int>(std::clamp((ndc + 1) / 2 * size + by, 0.0, double(size)));
    };
    const double m = 2 * std::ceil(static_cast<double>(margin)) + 4;
    const int x = pixel(low_.x, width, -m), y = pixel(low_.y, height, -m);
    return {x, y, pixel(high_.x, width, m) - x, pixel(high_.y, height, m) - y};
  }

 private:
  const View& view_;
  const Targets& targets_;
  glm::dvec2 low_{1e9}, high_{-1e9};
  bool everywhere_ = false;
};

}  // namespace

struct OutlineDrawer::Around {
  std::vector<const Surface*> surfaces;
  Colour colour{0};
  float width = thick;
  bool through = false;         // where something hides them, too
  bool already_masked = false;  // when they were drawn
};

OutlineDrawer::OutlineDrawer(SurfaceDrawer& surfaces)
    : surfaces_(surfaces), outline_("whole_picture.vert", "outline.frag") {}

void OutlineDrawer::draw(const View& view, Targets& targets) {
  std::vector<Around> all;
  Around selected;
  selected.colour = view.picture.surroundings.outline;
  selected.through = true;
  // In motion opaque surfaces are outlined where they are seen: that costs no further drawing.
  selected.already_masked = view.is_fast();
  for (const Surface& surface : view.picture.surfaces) {
    if (!surface.mesh) continue;
    if (surface.highlighted) {
      selected.surfaces.push_back(&surface);
      selected.already_masked &= surface.faces && !surface.translucent;
    } else if (surface.silhouette && !(view.is_fast() && surfaces_.is_dense(surface))) {
      Around thinly;
      thinly.surfaces = {&surface};
      thinly.colour = Colour(glm::vec3(surface.colour), 1);
      thinly.width = thin;
      all.push_back(thinly);
    }
  }
  // The mask that opaque surfaces left must be used before the others make theirs; what is drawn
  // last wins where lines meet.
  if (!selected.surfaces.empty()) all.push_back(selected);
  if (selected.already_masked && !selected.surfaces.empty())
    std::rotate(all.begin(), all.end() - 1, all.end());
  for (const Around& around : all) draw_around(view, targets, around);
}

void OutlineDrawer::draw_around(const View& view, Targets& targets, const Around& around) {
  PartFinder finder(view, targets);
  for (const Surface* surface : around.surfaces) finder.add(*surface);
  const float width = around.width * view.scale;
  const Part part = finder.found(width);
  if (part.is_empty()) return;
  glEnable(GL_SCISSOR_TEST);
  glScissor(part.x, part.y, part.width, part.height);
  if (!around.already_masked) {
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    for (const Surface* surface : around.surfaces)
      surfaces_.draw_mask(view, *surface, around.through);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  }
  targets.bind_flat_colour(part.x, part.y, part.width, part.height);
  // Around the part the mask is that of something else.
  const Part inner = shrunk(part, static_cast<int>(std::ceil(width)) + 1, targets);
  glScissor(inner.x, inner.y, inner.width, inner.height);
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  outline_.use();
  outline_.set("mask", 0);
  outline_.set("colour", around.colour);
  outline_.set("width", width);
  outline_.set("pixel", glm::vec2(1.0f / static_cast<float>(targets.width()),
                                  1.0f / static_cast<float>(targets.height())));
  glBindVertexArray(nothing_.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDisable(GL_BLEND);
  glEnable(GL_DEPTH_TEST);
  glDisable(GL_SCISSOR_TEST);
}

}  // namespace sectile::viewer
