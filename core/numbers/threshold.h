// From which size on work is done in another way: by a search instead of with all pairs, in parts,
// or by many threads.
#pragma once

namespace sectile {

/// The first size, or the second one in a build for tests (SECTILE_SMALL_CROWDS): there small
/// solids go the ways of large ones, and are judged by what is known of small ones.
template <class Number>
constexpr Number threshold([[maybe_unused]] Number usual, [[maybe_unused]] Number in_tests) {
#ifdef SECTILE_SMALL_CROWDS
  return in_tests;
#else
  return usual;
#endif
}

}  // namespace sectile
