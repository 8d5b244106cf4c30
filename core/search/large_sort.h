// Sorting on all cores where that is worth it.
#pragma once

#include <algorithm>
#include <cstddef>

#include "numbers/threshold.h"
#include "parallel/sort.h"

namespace sectile {

/// `less` must leave no two elements equal that can be told apart: their order would be anyhow.
template <class Container, class Less>
void large_sort(Container& elements, const Less& less) {
  constexpr std::size_t parallel_from = threshold(8192, 8);
  if (elements.size() < parallel_from)
    std::sort(elements.begin(), elements.end(), less);
  else
    parallel::sort(elements.begin(), elements.end(), less);
}

}  // namespace sectile
