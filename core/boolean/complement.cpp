#include "boolean/complement.h"

#include "boolean/boolean.h"

namespace sectile {
namespace {

// The solid meets itself along all of its edges, so each line is sorted once.
std::shared_ptr<const SolidData> paired_for_complement(const SolidData& solid) {
  const BooleanOptions options;
  Workspace w(options);
  FacePairs pairs;
  load(w, solid, solid, pairs);
  const Operation wanted[] = {Operation::unite};
  return assemble(w, cut(w, pairs, {wanted, true}), Operation::unite, 0).data();
}

}  // namespace

const SolidData& reversible(const SolidData& solid) {
  if (!solid.touches_itself()) return solid;
  return solid.complement([&] { return paired_for_complement(solid); });
}

}  // namespace sectile
