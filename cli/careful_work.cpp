#include "careful_work.h"

#include "interrupt.h"
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

void blame_illegal_operands(const Operands& operands, const std::function<void()>& work) {
  try {
    work();
  } catch (const InternalError&) {
    for (std::size_t i = 0; i < operands.solids.size(); ++i)
      require_legal(operands.names[i], operands.solids[i]);
    throw;
  }
}

std::vector<Written> compute_and_write(
    const Operands& operands, const std::vector<std::string>& outputs, const Options& options,
    Progress& progress, const std::function<std::vector<Solid>(const BooleanOptions&)>& work) {
  const Interrupt interrupt;
  BooleanOptions how;
  how.validate = options.validate;
  how.cancel = interrupt.requested();
  how.progress = [&](double done) { progress.fraction(done); };
  std::vector<Written> written;
  blame_illegal_operands(operands, [&] {
    const std::vector<Solid> results = work(how);
    if (options.validate) require_legal_results(operands, results);
    interrupt.check();
    written = write_solids(outputs, results, operands.unit, options, progress, interrupt);
  });
  return written;
}

}  // namespace sectile::cli
