// Elements that the texts name, lit and labelled in the picture of a step.
#pragma once

#include "story/sphere_picture.h"
#include "story/story_canvas.h"

namespace sectile::viewer {

class ElementCanvas : public StoryCanvas {
 protected:
  using StoryCanvas::StoryCanvas;
  void light_names(const TraceEvent& event, std::uint32_t place, double size);
  glm::dvec3 shown_place(const TraceEvent& event, std::uint32_t place) const;
  void light_row(const TraceEvent& event, double size);
  void name_middle(const TraceEvent& event);

 private:
  void light_name(int solid, const std::string& name, const glm::dvec3& centre,
                  const SpherePicture& sphere, double size);
};

}  // namespace sectile::viewer
