// The pictures of the components, of the gluing and of the cleanup: parts of the solids, pulled
// apart and brought together.
#pragma once

#include "story/exploded_parts.h"
#include "story/story_canvas.h"

namespace sectile::viewer {

class PartsPainter : public StoryCanvas {
 public:
  using StoryCanvas::StoryCanvas;
  Picture run();

 private:
  void paint_part(const Part& part, double exploded, bool highlighted);
  std::string name_of_part(const Part& part) const;
  bool is_of_no_interest(const Part& part) const;
  void paint_components();
  double apart() const;
  static void add_seam(Lines& seams, const TraceEvent& event, const glm::dvec3 (&moved)[2]);
  void paint_gluing();
  void paint_cleanup();
};

}  // namespace sectile::viewer
