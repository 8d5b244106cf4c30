// The colours of all pictures. Those that carry meaning are the same in the light and in the dark
// theme's hue and tell apart with the common kinds of colour blindness (after Okabe and Ito): what
// comes from A is blue, what comes from B orange; what lies inside the other solid is lighter.
#pragma once

#include "picture/picture.h"

namespace sectile::viewer {

struct Theme {
  Surroundings surroundings;
  Colour a, b;                              ///< the operands; alpha for translucent drawing
  Colour result, neutral;                   ///< results; solids without a role
  Colour a_in_b, a_out_b, b_in_a, b_out_a;  ///< the four parts
  Colour a_on_b_plus, a_on_b_minus;         ///< the eight-way parts: on, facing the same way
  Colour b_on_a_plus, b_on_a_minus;         ///< and facing opposite ways
  Colour coincident;                        ///< vertices of A and B in one place
  Colour contact, contact_segment;          ///< other places where the boundaries meet
  Colour null_edge, null_edge_above, null_edge_below;  ///< the edge, its two ends
  Colour cut;                                          ///< joined null edges: the cut loops
  Colour step;                                         ///< what the current step is about
  Colour selection, hover;
  Colour handle_x, handle_y, handle_z, handle_active;
  Colour text, text_halo;  ///< labels in the picture
};

const Theme& theme(bool dark);

/// The same colour with another alpha.
Colour with_alpha(Colour colour, float alpha);
/// Mixed with the background, for what is drawn fainter.
Colour fainter(Colour colour, const Theme& theme, float amount);

}  // namespace sectile::viewer
