// Cancelling and progress within the phases.
#pragma once

#include <atomic>
#include <functional>

#include "sectile/errors.h"

namespace sectile::arrangement {

struct Steering {
  const std::atomic<bool>* cancel = nullptr;
  std::function<void(double)> progress;

  /// Throws Cancelled if asked to; may be called from any thread.
  void check() const {
    if (cancel && cancel->load(std::memory_order_relaxed)) throw Cancelled();
  }
  void step(double done) const {
    check();
    if (progress) progress(done);
  }
};

}  // namespace sectile::arrangement
