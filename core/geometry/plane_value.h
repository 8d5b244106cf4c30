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
};

PlaneValue plane_value(const Geometry& geometry, PlaneId plane);

}  // namespace sectile
