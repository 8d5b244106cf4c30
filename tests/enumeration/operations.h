// The three operations on sets of cells and on solids.
#pragma once

#include "complex.h"
#include "sectile/boolean.h"

namespace sectile::test {

inline constexpr Operation all_operations[] = {Operation::unite, Operation::intersect,
                                               Operation::subtract};

inline const char* name_of(Operation operation) {
  return operation == Operation::unite       ? "unite"
         : operation == Operation::intersect ? "intersect"
                                             : "subtract";
}

inline Solid unite(const Solid& a, const Solid& b) {
  return boolean(a, b, Operation::unite);
}
inline Solid meet(const Solid& a, const Solid& b) {
  return boolean(a, b, Operation::intersect);
}
inline Solid minus(const Solid& a, const Solid& b) {
  return boolean(a, b, Operation::subtract);
}

inline Mask combined(Mask a, Mask b, Operation operation) {
  return operation == Operation::unite ? a | b : operation == Operation::intersect ? a & b : a & ~b;
}

}  // namespace sectile::test
