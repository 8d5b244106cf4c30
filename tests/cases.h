// How many random cases a test runs.
#pragma once

#include <concepts>

namespace sectile {

/// Under the sanitizers a third: each takes ten times as long there, and what they look for is not
/// what the case gives but what is read and computed on the way.
template <std::integral Count>
constexpr Count cases(Count count) {
#ifdef SECTILE_SANITIZE
  return (count + 2) / 3;
#else
  return count;
#endif
}

}  // namespace sectile
