// The box around the selection with its lengths, as lines and labels.
#pragma once

#include "app/picture_maker.h"

namespace sectile::viewer {

/// Around those of the shapes that are selected, or belong to what is.
void add_dimensions(Picture& picture, const Document& document, const ViewState& view,
                    const std::vector<Shape>& shapes);

/// The box around what is drawn of the selection: close, also for what is turned.
Bounds close_bounds_of_selection(const Document& document, const std::vector<Shape>& shapes);

}  // namespace sectile::viewer
