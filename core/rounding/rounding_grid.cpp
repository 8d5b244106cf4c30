#include "rounding/rounding_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sectile {

Rounding::Numbers numbers_of(FileFormat format) {
  const bool floats = format == FileFormat::stl_binary || format == FileFormat::three_mf;
  return floats ? Rounding::Numbers::floats : Rounding::Numbers::doubles;
}

double nearest_multiple(double value, double spacing) {
  if (!std::isfinite(spacing)) return 0;
  // Where multiples are as near to each other as doubles, each double is the nearest to one.
  const double steps = value / spacing;
  return std::abs(steps) < 0x1p53 ? std::nearbyint(steps) * spacing : value;
}

RoundingGrid::RoundingGrid(const Rounding& rounding)
    : numbers_(rounding.numbers), spacing_(rounding.spacing) {
  if (numbers_ == Rounding::Numbers::grid && !(spacing_ > 0 && std::isfinite(spacing_)))
    throw Error("the spacing of a grid must be a positive number");
}

double RoundingGrid::nearest(double value) const {
  switch (numbers_) {
    case Rounding::Numbers::floats:
      return static_cast<double>(static_cast<float>(value));
    case Rounding::Numbers::grid:
      return nearest_multiple(value, spacing_);
    case Rounding::Numbers::doubles:
      break;
  }
  return value;
}

double RoundingGrid::step(const Vec3& p) const {
  const double size = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  switch (numbers_) {
    case Rounding::Numbers::floats: {
      const auto near = static_cast<float>(size);
      return static_cast<double>(std::nextafter(near, std::numeric_limits<float>::infinity())) -
             static_cast<double>(near);
    }
    case Rounding::Numbers::grid:
      return spacing_;
    case Rounding::Numbers::doubles:
      break;
  }
  return std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
}

}  // namespace sectile
