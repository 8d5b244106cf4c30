#include "careful_work.h"

#include "input.h"
#include "problem.h"

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

std::vector<Solid> run_carefully(
    const Operands& operands, const Options& options, Progress& progress,
    const Interrupt& interrupt,
    const std::function<std::vector<Solid>(const BooleanOptions&)>& work) {
  BooleanOptions how;
  how.validate = options.validate;
  how.cancel = interrupt.requested();
  how.progress = [&](double done) { progress.fraction(done); };
  try {
    std::vector<Solid> results = work(how);
    if (options.validate) require_legal_results(operands, results);
    interrupt.check();
    return results;
  } catch (const InternalError&) {
    for (std::size_t i = 0; i < operands.solids.size(); ++i)
      require_legal(operands.names[i], operands.solids[i]);
    throw;
  }
}

}  // namespace sectile::cli
