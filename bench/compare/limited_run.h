// Runs work in a process of its own, which is ended when its time is over.
#pragma once

#include <functional>
#include <optional>

#include "corefinement.h"

namespace sectile::bench {

/// What the work measured, or nothing if it was not done after so many seconds. Throws
/// std::runtime_error if the process ended otherwise.
std::optional<Measured> limited_run(unsigned seconds, const std::function<Measured()>& work);

}  // namespace sectile::bench
