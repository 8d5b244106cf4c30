// Runs an operation so that it can be interrupted, shows its progress, and blames the right one.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "interrupt.h"
#include "options.h"
#include "progress.h"
#include "sectile/boolean.h"

namespace sectile::cli {

/// Operands and the names of their files.
struct Operands {
  std::vector<std::string> names;
  std::vector<Solid> solids;
};

/// Calls `work` with the options that the command line asks for. An internal error is a defect of
/// the library only if the operands are legal; if one is not, IllegalInput is thrown instead. With
/// --validate the results are checked too.
std::vector<Solid> run_carefully(
    const Operands& operands, const Options& options, Progress& progress,
    const Interrupt& interrupt,
    const std::function<std::vector<Solid>(const BooleanOptions&)>& work);

}  // namespace sectile::cli
