#include "pairs.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <sstream>

#include "boolean/boolean.h"
#include "sectile/errors.h"

namespace sectile::test {
namespace {

struct Failure {
  std::size_t index;
  Operation operation;
  std::string what;
};

Solid imported(const Complex& complex, Mask mask, Meshing how) {
  return Solid::from_mesh(Boundary(complex, mask).mesh(how));
}

std::string fault_of(const PairCheck& check, const Solid& a, const Solid& b, const Pair& pair,
                     Operation operation) {
  const auto fault_in = [&](const Solid& result) {
    return fault(result, check.complex, combined(pair.a, pair.b, operation), check.geometry);
  };
  try {
    const std::string found = fault_in(boolean(a, b, operation));
    if (!found.empty() || pair.a != pair.b) return found;
    return fault_in(boolean_by_cutting(a, b, operation, {}));  // which is not done for equal faces
  } catch (const Error& error) {
    return error.what();
  }
}

std::string fault_from_scratch(const PairCheck& check, const Pair& pair, Operation operation) {
  try {
    return fault_of(check, imported(check.complex, pair.a, check.meshing_a),
                    imported(check.complex, pair.b, check.meshing_b), pair, operation);
  } catch (const InvalidSolid& error) {
    return error.what();
  }
}

std::string report(const PairCheck& check, const Pair& pair, const Failure& failure) {
  const auto [a, b] = shrunk(pair.a, pair.b, [&](Mask smaller_a, Mask smaller_b) {
    return !fault_from_scratch(check, {smaller_a, smaller_b}, failure.operation).empty();
  });
  std::ostringstream text;
  text << std::hex << name_of(failure.operation) << " 0x" << a << ", 0x" << b << ": "
       << fault_from_scratch(check, {a, b}, failure.operation) << " (shrunk from 0x" << pair.a
       << ", 0x" << pair.b << ": " << failure.what << ")";
  return text.str();
}

// Each set is imported once, however often it occurs.
std::map<Mask, Solid> imported_sets(const Complex& complex, std::span<const Pair> pairs,
                                    Mask Pair::*member, Meshing how) {
  std::map<Mask, Solid> solids;
  for (const Pair& pair : pairs) solids.try_emplace(pair.*member);
  std::vector<std::map<Mask, Solid>::value_type*> entries;
  for (auto& entry : solids) entries.push_back(&entry);
  tbb::parallel_for(std::size_t{0}, entries.size(), [&](std::size_t i) {
    entries[i]->second = imported(complex, entries[i]->first, how);
  });
  return solids;
}

}  // namespace

std::vector<std::string> faults_of_pairs(const PairCheck& check, std::span<const Pair> pairs) {
  const auto solids_a = imported_sets(check.complex, pairs, &Pair::a, check.meshing_a);
  const auto solids_b = imported_sets(check.complex, pairs, &Pair::b, check.meshing_b);
  std::vector<Failure> failures;
  std::mutex mutex;
  tbb::parallel_for(std::size_t{0}, pairs.size(), [&](std::size_t i) {
    const Pair& pair = pairs[i];
    for (const Operation operation : all_operations) {
      const std::string what =
          fault_of(check, solids_a.at(pair.a), solids_b.at(pair.b), pair, operation);
      if (what.empty()) continue;
      const std::lock_guard lock(mutex);
      failures.push_back({i, operation, what});
    }
  });
  std::sort(failures.begin(), failures.end(), [](const Failure& f, const Failure& g) {
    return std::pair(f.index, f.operation) < std::pair(g.index, g.operation);
  });
  std::vector<std::string> reports;
  for (const Failure& failure : failures) {
    if (reports.size() == 10) {
      reports.push_back(std::to_string(failures.size()) + " in all");
      break;
    }
    reports.push_back(report(check, pairs[failure.index], failure));
  }
  return reports;
}

}  // namespace sectile::test
