// Places along Hilbert's curve: neighbours on it are neighbours in space, and any piece of it fills
// a region that hangs together, so that blocks of faces along it have short borders.
//
// The curve goes through the eight octants of a cube one by one, and through each of them in the
// same way, turned: from which corner it starts and along which axis it leaves says how (C. H.
// Hamilton, Compact Hilbert Indices, 2006).
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "search/box.h"

namespace sectile {

namespace hilbert {

/// How the curve runs through a cube, and the octants in its order.
struct Step {
  std::uint8_t place;  ///< of an octant on the curve
  std::uint8_t state;  ///< of the curve within it
};

constexpr unsigned turned_left(unsigned octant, unsigned by) {
  return (octant << by | octant >> (3 - by)) & 7u;
}
constexpr unsigned turned_right(unsigned octant, unsigned by) {
  return turned_left(octant, 3 - by);
}
constexpr unsigned gray_code(unsigned i) {
  return i ^ i >> 1;
}
constexpr unsigned place_of_gray_code(unsigned code) {
  return code ^ code >> 1 ^ code >> 2;
}
/// The axis along which the curve goes on from its i-th octant.
constexpr unsigned axis_after(unsigned i) {
  unsigned axis = 0;
  for (; i & 1u; i >>= 1) ++axis;
  return axis % 3;
}

/// Per state, three times the corner where the curve enters plus an axis, and octant.
constexpr std::array<std::array<Step, 8>, 24> make_steps() {
  std::array<std::array<Step, 8>, 24> steps{};
  for (unsigned state = 0; state < 24; ++state)
    for (unsigned octant = 0; octant < 8; ++octant) {
      const unsigned corner = state / 3, axis = state % 3, turn = (axis + 1) % 3;
      const unsigned place = place_of_gray_code(turned_right(octant ^ corner, turn));
      const unsigned enters = place == 0 ? 0 : gray_code((place - 1) / 2 * 2);
      const unsigned along = place == 0 ? 0 : axis_after(place % 2 == 0 ? place - 1 : place);
      const unsigned next = (corner ^ turned_left(enters, turn)) * 3 + (axis + along + 1) % 3;
      steps[state][octant] = {static_cast<std::uint8_t>(place), static_cast<std::uint8_t>(next)};
    }
  return steps;
}
inline constexpr std::array<std::array<Step, 8>, 24> steps = make_steps();

/// Two steps at a time: octants of octants.
constexpr std::array<std::array<Step, 64>, 24> make_double_steps() {
  std::array<std::array<Step, 64>, 24> made{};
  for (unsigned state = 0; state < 24; ++state)
    for (unsigned octants = 0; octants < 64; ++octants) {
      const Step first = steps[state][octants / 8], second = steps[first.state][octants % 8];
      made[state][octants] = {static_cast<std::uint8_t>(first.place * 8 + second.place),
                              second.state};
    }
  return made;
}
inline constexpr std::array<std::array<Step, 64>, 24> double_steps = make_double_steps();
/// Two bits, with room for those of two more axes.
inline constexpr std::uint8_t spread[] = {0, 1, 8, 9};

}  // namespace hilbert

/// The place of a point, or of a box's centre, in a grid of 1024³ cells.
class HilbertCurve {
 public:
  static constexpr unsigned bits = 30;

  explicit HilbertCurve(const Box& bounds) {
    for (int k = 0; k < 3; ++k) {
      low_[k] = bounds.low[k];
      const double extent = double(bounds.high[k]) - bounds.low[k];
      scale_[k] = extent > 0 && std::isfinite(extent) ? 1024.0 / extent : 0.0;
    }
  }
  std::uint32_t operator()(const Box& box) const {
    const auto middle = [&](int k) { return 0.5 * (double(box.low[k]) + box.high[k]); };
    return (*this)(Vec3{middle(0), middle(1), middle(2)});
  }
  std::uint32_t operator()(const Vec3& place) const {
    const std::uint32_t x = cell(place.x, 0), y = cell(place.y, 1), z = cell(place.z, 2);
    return place_of_cell(x, y, z);
  }

  /// Of a cell of the grid.
  static std::uint32_t place_of_cell(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    std::uint32_t place = 0, state = 0;
    for (int bit = 8; bit >= 0; bit -= 2) {
      const auto two_of = [bit](std::uint32_t at) -> std::uint32_t {
        return hilbert::spread[at >> bit & 3u];
      };
      const std::uint32_t octants = two_of(x) | two_of(y) << 1 | two_of(z) << 2;
      const hilbert::Step step = hilbert::double_steps[state][octants];
      place = place << 6 | step.place;
      state = step.state;
    }
    return place;
  }

 private:
  std::uint32_t cell(double at, int k) const {
    const double cell = (at - low_[k]) * scale_[k];
    return cell >= 1023 ? 1023u : cell > 0 ? static_cast<std::uint32_t>(cell) : 0u;
  }

  double low_[3], scale_[3];
};

}  // namespace sectile
