// Sorting on all cores; see parallel/parallel.h.
#pragma once

#include <cstddef>
#include <functional>

#ifndef SECTILE_SANITIZE_THREADS
#include <tbb/parallel_sort.h>
#include <tbb/task_group.h>
#endif

#include <algorithm>

#include "parallel/alone.h"

namespace sectile::parallel {

template <class Iterator, class Less = std::less<>>
void sort(Iterator begin, Iterator end, const Less& less = Less()) {
#ifndef SECTILE_SANITIZE_THREADS       // which sees races in TBB's own sorting
  constexpr std::ptrdiff_t few = 500;  // as for TBB, which sorts these on one core
  if (end - begin >= few && !Alone::now()) {
    tbb::task_group_context own(tbb::task_group_context::isolated);
    tbb::task_group(own).run_and_wait([&] { tbb::parallel_sort(begin, end, less); });
    return;
  }
#endif
  std::sort(begin, end, less);
}

}  // namespace sectile::parallel
