// Growth tests: how many steps does core take for n things, and for several times as many? They
// count, and look at no clock: the same program takes the same steps on every machine, however busy
// it is. A step is a basic block of core that is run, or 64 bytes that are allocated.
//
// They need a core that is compiled to count:
//
//     cmake --preset growth && cmake --build --preset growth && ctest --preset growth
//
// A new test is a function that makes the input for a size and returns the work to be counted (what
// is prepared there is not), and a size that takes about 50 ms:
//
//     TEST(Growth, ImportOfCubesInARow) {
//       EXPECT_LT(growth([](std::size_t n) {
//         return [mesh = cubes_in_a_row(n)] { Solid::from_mesh(mesh); };
//       }, 500), n_log_n);
//     }
//
// What is not in core is not counted (tests, oneTBB's library; what its headers put into core is).
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>

namespace sectile {

/// The steps that the work takes on one thread.
std::uint64_t steps_of(const std::function<void()>& work);

/// The exponent of growth: 1 if four times as many things take four times as many steps, 2 if they
/// take sixteen times as many. `prepare(n)` returns the work for n things.
template <class Prepare>
double growth(const Prepare& prepare, std::size_t n) {
  const std::uint64_t few = steps_of(prepare(n)), many = steps_of(prepare(4 * n));
  return std::log2(static_cast<double>(many) / static_cast<double>(few)) / 2;
}

/// Above what n log n takes for all sizes in these tests (4 n log 4 n / n log n with n = 100 is
/// 4^1.19), and far below n².
inline constexpr double n_log_n = 1.25;

}  // namespace sectile
