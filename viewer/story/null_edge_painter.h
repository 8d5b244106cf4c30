// The picture of the null edges: their ends pulled apart.
#pragma once

#include "story/story_canvas.h"

namespace sectile::viewer {

class NullEdgePainter : public StoryCanvas {
 public:
  using StoryCanvas::StoryCanvas;
  Picture run();

 private:
  double pull(const NullEdgeEvent& event) const;
  void add_null_edge(const TraceEvent& event, Lines& edge, Points& from, Points& to) const;
  void paint_uncut();
  void paint_null_edges();
};

}  // namespace sectile::viewer
