// How far an import is.
#pragma once

#include "sectile/errors.h"
#include "sectile/solid.h"

namespace sectile {

/// Tells how far the import is, and ends it where that was asked for. The test against itself takes
/// most of the time.
class ImportSteps {
 public:
  explicit ImportSteps(const ImportOptions& options) : options_(options) {}

  void done(double part) const {
    if (options_.cancel && options_.cancel->load(std::memory_order_relaxed)) throw Cancelled();
    if (options_.progress) options_.progress(part);
  }
  /// For the test against itself.
  ImportOptions from_to(double begin, double end) const {
    ImportOptions inner = options_;
    if (options_.progress)
      inner.progress = [begin, end, &outer = options_.progress](double part) {
        outer(begin + part * (end - begin));
      };
    return inner;
  }

 private:
  const ImportOptions& options_;
};

}  // namespace sectile
