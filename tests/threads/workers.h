// oneTBB is not compiled with ThreadSanitizer, which does not see how its threads hand tasks over
// and takes all that tasks share for races. Under it, each thread does its tasks itself: what is
// watched is what solids share among threads.
#pragma once

#ifdef __SANITIZE_THREAD__
#include <tbb/global_control.h>

namespace sectile {
inline const tbb::global_control no_workers(tbb::global_control::max_allowed_parallelism, 1);
}

#define SECTILE_NEEDS_WORKERS \
  GTEST_SKIP() << "ThreadSanitizer does not see what the threads of oneTBB hand over."
#else
#define SECTILE_NEEDS_WORKERS static_cast<void>(0)
#endif
