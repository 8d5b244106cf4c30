// Cancelling and progress, where nobody knows how many parts of the work there will be.
#pragma once

#include "sectile/rounding.h"
#include "selftest/self_test.h"

namespace sectile {

class RoundingSteps {
 public:
  explicit RoundingSteps(const Rounding& options) : options_(options) {}

  /// For a part that takes this share of what is left.
  SelfTestControl part(double share) {
    const double begin = done_, size = share * (1 - done_);
    done_ += size;
    SelfTestControl control{options_.cancel, {}};
    if (options_.progress)
      control.progress = [begin, size, &tell = options_.progress](double done) {
        tell(begin + done * size);
      };
    return control;
  }
  void check() const {
    if (options_.cancel && options_.cancel->load(std::memory_order_relaxed)) throw Cancelled();
  }
  /// A part that takes this share of what is left has been done.
  void pass(double share) {
    done_ += share * (1 - done_);
    if (options_.progress) options_.progress(done_);
    check();
  }
  void finish() const {
    if (options_.progress) options_.progress(1);
  }

 private:
  const Rounding& options_;
  double done_ = 0;
};

}  // namespace sectile
