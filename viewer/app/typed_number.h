// Numbers as people type them: "40/2", "20,5", "(3 + 1/8) in", "90\u00B0".
#pragma once

#include <string>

namespace sectile::viewer {

/// What a number measures. Scenes have no unit of their own; where one is typed they are taken to
/// be in millimetres, as most printers and mills do. Angles are in degrees.
enum class Quantity { plain, length, angle };

/// The double nearest to what was typed. Takes + - * / and brackets, a decimal point or a decimal
/// comma, "pi", and units: mm, cm, m, in (or "), ft for lengths; \u00B0 (or deg), rad for angles; %
/// for plain numbers. Throws std::invalid_argument with a sentence that says what cannot be read.
double typed_number(const std::string& text, Quantity quantity);

/// As few digits as bring back the same double.
std::string shortest(double value);

}  // namespace sectile::viewer
