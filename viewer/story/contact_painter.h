// The pictures of the reduction, of the neighborhoods and of the joining: contacts and what lies
// around one of them.
#pragma once

#include "story/element_canvas.h"

namespace sectile::viewer {

class ContactPainter : public ElementCanvas {
 public:
  using ElementCanvas::ElementCanvas;
  Picture run();

 private:
  void paint_reduction();
  void paint_neighborhoods();
  void paint_joining();
};

}  // namespace sectile::viewer
