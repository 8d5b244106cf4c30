// A plane's coefficients in doubles, for the first evaluation of a test.
#pragma once

#include "geometry/geometry.h"

namespace sectile {

/// The true coefficients differ by at most the errors.
struct PlaneValue {
  double n[3];
  double d;
  double n_error;  ///< bound for each component of the normal
  double d_error;
  bool exact;  ///< both errors are zero
  /// Of x, y or z = const, the normal being ±1 exactly: that axis; otherwise -1.
  std::int8_t axis = -1;
};

PlaneValue plane_value(const Geometry& geometry, PlaneId plane);

}  // namespace sectile
