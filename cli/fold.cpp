#include "fold.h"

namespace sectile::cli {
namespace {

// Reports the progress of each step as a part of the whole.
class Steps {
 public:
  Steps(std::size_t count, const BooleanOptions& options) : count_(count), options_(options) {}

  Solid run(const Solid& a, const Solid& b, Operation operation) {
    BooleanOptions options = options_;
    if (options_.progress)
      options.progress = [this](double done) {
        options_.progress((static_cast<double>(done_) + done) / static_cast<double>(count_));
      };
    Solid result = boolean(a, b, operation, options);
    ++done_;
    return result;
  }

 private:
  std::size_t count_, done_ = 0;
  const BooleanOptions& options_;
};

// Neighbours in pairs, again and again, so that no operand is copied more than log(n) times.
Solid unite_all(std::vector<Solid> solids, Steps& steps) {
  while (solids.size() > 1) {
    std::vector<Solid> united;
    for (std::size_t i = 0; i + 1 < solids.size(); i += 2)
      united.push_back(steps.run(solids[i], solids[i + 1], Operation::unite));
    if (solids.size() % 2 == 1) united.push_back(solids.back());
    solids = std::move(united);
  }
  return solids.front();
}

}  // namespace

Solid fold(std::vector<Solid> operands, Operation operation, const BooleanOptions& options) {
  Steps steps(operands.size() - 1, options);
  if (operation == Operation::unite) return unite_all(std::move(operands), steps);
  Solid result = operands.front();
  operands.erase(operands.begin());
  if (operation == Operation::subtract)
    return steps.run(result, unite_all(std::move(operands), steps), operation);
  for (const Solid& operand : operands) result = steps.run(result, operand, operation);
  return result;
}

}  // namespace sectile::cli
