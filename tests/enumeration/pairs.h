// Runs many pairs of sets of cells on all cores and reports what is wrong in the smallest form.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "fault.h"
#include "operations.h"

namespace sectile::test {

struct Pair {
  Mask a, b;
};

/// How a list of pairs is to be checked.
struct PairCheck {
  const Complex& complex;
  Meshing meshing_a, meshing_b;
  bool geometry;  ///< test the faces of results against each other
};

/// What is wrong with A ∪ B, A ∩ B and A \ B, each with the pair shrunk as far as it still fails.
/// At most ten; the sets are named by their bits, in the order of the list.
std::vector<std::string> faults_of_pairs(const PairCheck& check, std::span<const Pair> pairs);

}  // namespace sectile::test
