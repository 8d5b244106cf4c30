// oneTBB is not compiled with ThreadSanitizer, which does not see how its threads hand tasks over
// and takes all that tasks share for races. Under it, core's loops run on threads of their own
// (parallel/watched.cpp), and oneTBB starts none.
#pragma once

#ifdef SECTILE_SANITIZE_THREADS
#include <tbb/global_control.h>

namespace sectile {
inline const tbb::global_control no_workers(tbb::global_control::max_allowed_parallelism, 1);
inline constexpr int rounds = 20;  // it sees what races without being lucky
}  // namespace sectile

// For tests with loops of oneTBB around core's.
#define SECTILE_NEEDS_WORKERS \
  GTEST_SKIP() << "ThreadSanitizer does not see what the threads of oneTBB hand over."
#else
namespace sectile {
inline constexpr int rounds = 600;
}

#define SECTILE_NEEDS_WORKERS static_cast<void>(0)
#endif
