// How much memory the process held at most since a moment.
#pragma once

namespace sectile::bench {

/// Forgets earlier peaks. Throws std::runtime_error where the system cannot do that.
void reset_peak_memory();
/// In MiB, of the whole process.
double peak_memory();

}  // namespace sectile::bench
