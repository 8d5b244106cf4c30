// Fields of numbers: drag to change, click to type (typed_number.h says what is understood).
#pragma once

#include <cstdint>
#include <string>

#include "app/typed_number.h"

namespace sectile::viewer {

struct PanelContext;

/// What happened to a field in this frame.
struct Edited {
  bool changing = false;  ///< the value is another now
  bool done = false;      ///< the change is complete: one step of undo
};

/// What a field takes. What is typed outside of it is refused in words; drags stop at its ends.
struct NumberRange {
  double low = -1e9, high = 1e9;
};

/// `beside`: what the value that is meant has beside the double; it is shown for typing.
Edited number_field(PanelContext& context, const std::string& name, double& value, double speed,
                    float width, Quantity quantity, NumberRange range = {}, double beside = 0);
Edited count_field(PanelContext& context, const std::string& name, std::uint32_t& value, int low,
                   int high, float width);

/// A number that is being typed; at most one at a time.
struct TypedField {
  std::string field;  ///< its name; empty: none
  std::string text;
  std::string original;  ///< what stood there before
  bool has_focus = false;
  bool wants_next = false;  ///< Tab was pressed: the next field that is drawn takes over
  bool is_drawn = false;    ///< in this frame; if not, its panel is gone
};

}  // namespace sectile::viewer
