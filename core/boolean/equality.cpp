// Equality of point sets: two regular sets are equal if neither has a part outside the other.
#include "sectile/boolean.h"

namespace sectile {

bool operator==(const Solid& a, const Solid& b) {
  if (a.data() == b.data()) return true;
  if (a.is_empty() || b.is_empty()) return a.is_empty() == b.is_empty();
  return boolean(a, b, Operation::subtract).is_empty() &&
         boolean(b, a, Operation::subtract).is_empty();
}

}  // namespace sectile
