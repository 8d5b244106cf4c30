// Sorting on all cores where that is worth it.
#pragma once

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cstddef>

namespace sectile {

/// `less` must leave no two elements equal that can be told apart: their order would be anyhow.
template <class Container, class Less>
void large_sort(Container& elements, const Less& less) {
  constexpr std::size_t parallel_from = 8192;
  if (elements.size() < parallel_from)
    std::sort(elements.begin(), elements.end(), less);
  else
    tbb::parallel_sort(elements.begin(), elements.end(), less);
}

}  // namespace sectile
