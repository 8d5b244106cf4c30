// Filling of large vectors on all cores. The system gives memory when it is first written to, which
// is most of what a large table costs: while one core does that for all, the others wait.
#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>

#include "numbers/threshold.h"
#include "numbers/unset_vector.h"
#include "parallel/parallel.h"

namespace sectile {

/// As resize(size, value). The caller may hold a lock: a thread that waits for the others takes no
/// other work meanwhile.
template <class T>
void resize_filled(UnsetVector<T>& vector, std::size_t size, const T& value) {
  constexpr std::size_t part = threshold(std::size_t(1) << 18, std::size_t(64)) / sizeof(T) + 1;
  const std::size_t before = vector.size();
  if (!std::is_trivially_copyable_v<T> || size < before + 2 * part)
    return vector.resize(size, value);
  const T filling = value;  // which may be an element
  vector.resize(size);
  T* const elements = vector.data();
  parallel::isolate([&] {
    parallel::loop(parallel::Range<std::size_t>(before, size, part), [&](const auto& some) {
      std::fill(elements + some.begin(), elements + some.end(), filling);
    });
  });
}

}  // namespace sectile
