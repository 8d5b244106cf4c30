#include "events/wake.h"

#include <mutex>

namespace sectile::viewer {
namespace {

// A plain pointer would do for the calls, but not for a window that goes while one of them runs.
std::mutex mutex;
void (*wakes)() = nullptr;

}  // namespace

void wake() {
  const std::lock_guard lock(mutex);
  if (wakes) wakes();
}

void set_wake(void (*function)()) {
  const std::lock_guard lock(mutex);
  wakes = function;
}

}  // namespace sectile::viewer
