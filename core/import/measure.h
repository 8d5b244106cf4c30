// Volume and area of the exact solid, right to two units in the last place.
//
// Sums in pairs of doubles with a bound of their error, block by block: what blocks add is kept
// with them. What these leave open is left to numbers of any length (measure_exactly.cpp).
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "numbers/bounded.h"
#include "parallel/parallel.h"
#include "storage/solid_data.h"
#include "topology/fans.h"

namespace sectile {

/// Of a solid that is not empty, as far as pairs of doubles know them.
Bounded six_volumes_of(const SolidData& solid);
Bounded two_areas_of(const SolidData& solid);

/// Of a solid that is not empty.
double volume_of(const SolidData& solid);
double area_of(const SolidData& solid);

/// Some of the faces of a boundary.
struct SomeFaces {
  const Brep& brep;
  const Geometry& geometry;
  std::vector<FaceId> faces;
};
/// Of all of them; zero if there are none.
double area_of(std::span<const SomeFaces> parts);

double exact_volume(const SolidData& solid);
double exact_area(const SolidData& solid);
double exact_area(std::span<const SomeFaces> parts);

/// The sum of part(from, to) over ranges of faces. The ranges do not depend on the number of
/// threads, nor does the order of the sum.
template <class Number, class Part>
Number sum_over_faces(std::size_t faces, const Part& part) {
  constexpr std::size_t step = 1024;
  std::vector<Number> parts((faces + step - 1) / step);
  const auto fill = [&](std::size_t i) {
    parts[i] = part(i * step, std::min((i + 1) * step, faces));
  };
  if (parts.size() < 4) {
    for (std::size_t i = 0; i < parts.size(); ++i) fill(i);
  } else {
    parallel::loop(0, parts.size(), fill);
  }
  Number sum{};
  for (const Number& p : parts) sum = sum + p;
  return sum;
}

}  // namespace sectile
