#include "parallel/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace sectile::parallel {

void run_parts(std::size_t first, std::size_t last, std::size_t grain,
               Work<std::size_t, std::size_t> work) {
  if (last - first <= grain) return work(first, last);  // calls nobody
  tbb::task_group_context own(tbb::task_group_context::isolated);
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(first, last, grain),
      [work](const auto& part) { work(part.begin(), part.end()); }, own);
}

void run_isolated(Work<> work) {
  tbb::this_task_arena::isolate(work);
}

}  // namespace sectile::parallel
