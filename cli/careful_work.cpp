#include "careful_work.h"

#include "problem.h"
#include "write_solids.h"

namespace sectile::cli {
namespace {

void require_legal_results(const Operands& operands, const std::vector<Solid>& results) {
  for (const Solid& result : results) {
    const std::vector<Violation> violations = validate(result);
    if (violations.empty()) continue;
    std::string message = "the result is not legal: " + violations.front().what + "; operands:";
    for (const std::string& name : operands.names) message += " " + name;
    throw InternalError(message);
  }
}

}  // namespace

std::vector<Written> compute_and_write(
    const Operands& operands, const std::vector<std::string>& outputs, const Options& options,
    Progress& progress, const std::function<std::vector<Solid>(const BooleanOptions&)>& work) {
  BooleanOptions how;
  how.validate = options.validate;
  how.progress = [&](double done) { progress.fraction(done); };
  const std::vector<Solid> results = work(how);
  if (options.validate) require_legal_results(operands, results);
  return write_solids(outputs, results, operands.unit, options, progress);
}

}  // namespace sectile::cli
