// From operands to files: work that can be interrupted and shows its progress.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "input.h"
#include "options.h"
#include "progress.h"
#include "sectile/boolean.h"
#include "summary.h"

namespace sectile::cli {

/// Calls `work` with the options that the command line asks for, and writes its results, one for
/// each output. With --validate the results are checked first.
std::vector<Written> compute_and_write(
    const Operands& operands, const std::vector<std::string>& outputs, const Options& options,
    Progress& progress, const std::function<std::vector<Solid>(const BooleanOptions&)>& work);

}  // namespace sectile::cli
