// Equality of point sets: two regular sets are equal if neither has a part outside the other.
#include "boolean/boolean.h"
#include "boolean/same_faces.h"
#include "import/measure.h"

namespace sectile {
namespace {

bool differ(const Bounded& a, const Bounded& b) {
  return (a - b).decided();
}

}  // namespace

// Nearly always the faces are the same, or the volumes are not, and blocks know that.
bool operator==(const Solid& a, const Solid& b) {
  if (a.data() == b.data()) return true;
  if (a.is_empty() || b.is_empty()) return a.is_empty() == b.is_empty();
  if (differ(six_volumes_of(*a.data()), six_volumes_of(*b.data())) ||
      differ(two_areas_of(*a.data()), two_areas_of(*b.data())))
    return false;
  if (have_same_faces(*a.data(), *b.data())) return true;
  return boolean_by_cutting(a, b, Operation::subtract, {}).is_empty() &&
         boolean_by_cutting(b, a, Operation::subtract, {}).is_empty();
}

}  // namespace sectile
