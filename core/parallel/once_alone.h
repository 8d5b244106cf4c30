// What is found out when it is first asked for, perhaps by several threads at a time.
#pragma once

#include <tbb/task_arena.h>

#include <mutex>

namespace sectile {

/// call_once, in isolation: a thread that waits for its own parallel loop within must not take up
/// an outer task that enters the same call_once, or it would wait for itself.
template <class Body>
void once_alone(std::once_flag& flag, const Body& body) {
  std::call_once(flag, [&] { tbb::this_task_arena::isolate(body); });
}

}  // namespace sectile
