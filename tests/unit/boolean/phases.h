// Runs the phases of one Boolean one by one, with all checks.
#pragma once

#include <optional>

#include "boolean/check_links.h"
#include "boolean/components/components.h"
#include "boolean/gluing/gluing.h"
#include "boolean/loading/load.h"
#include "sectile/primitives.h"

namespace sectile::test {

/// Each phase is run once, in order, when it is first asked for.
class Phases {
 public:
  /// Of one block each, so that the numbers of entities do not depend on how solids are stored.
  Phases(const Solid& a, const Solid& b, Operation operation)
      : a_(a), b_(b), operation_(operation), w(options_) {
    options_.validate = true;
    load(w, a_.data()->in_one_block(), b_.data()->in_one_block(), pairs_);
  }

  const Contacts& contacts() {
    return once(contacts_, [&] { return reduce(w, pairs_); });
  }
  const Neighborhoods& neighborhoods() {
    const Contacts& c = contacts();
    return once(neighborhoods_,
                [&] { return find_neighborhoods(w, c, {std::span(&operation_, 1)}); });
  }
  const CutPlan& plan() {
    const Neighborhoods& n = neighborhoods();
    return once(plan_, [&] { return plan_cuts(w, n); });
  }
  const Cuts& cuts() {
    const CutPlan& p = plan();
    return once(cuts_, [&] { return insert_null_edges(w, *contacts_, *neighborhoods_, p); });
  }
  const JoinedCuts& joined() {
    const Cuts& c = cuts();
    return once(joined_, [&] { return join_null_edges(w, *neighborhoods_, c); });
  }
  const FaceLabels& kept() {
    const JoinedCuts& j = joined();
    return once(kept_, [&] { return find_kept(w, *contacts_, *neighborhoods_, j, operation_); });
  }
  Glued glued() {
    const FaceLabels& k = kept();
    return glue(w, operation_, *neighborhoods_, neighborhoods_->wedges[0], *joined_, k);
  }

  Vec3 position(PlaceId place) { return w.geometry.position(contacts().point(place)); }

 private:
  template <class T, class Make>
  const T& once(std::optional<T>& known, const Make& make) {
    if (!known) known = make();
    return *known;
  }

  Solid a_, b_;
  Operation operation_;
  BooleanOptions options_;

 public:
  Workspace w;

 private:
  FacePairs pairs_;
  std::optional<Contacts> contacts_;
  std::optional<Neighborhoods> neighborhoods_;
  std::optional<CutPlan> plan_;
  std::optional<Cuts> cuts_;
  std::optional<JoinedCuts> joined_;
  std::optional<FaceLabels> kept_;
};

/// Two cubes that overlap in a corner, [1, 2]³. Their boundaries meet in a hexagon; its corners lie
/// by turns on an edge of A in a face of B and the other way round.
inline Solid lower_cube() {
  return block({0, 0, 0}, {2, 2, 2});
}
inline Solid upper_cube() {
  return block({1, 1, 1}, {3, 3, 3});
}
/// Beside the lower cube: they share the face x = 2 and its four edges.
inline Solid flush_block() {
  return block({2, 0, 0}, {3, 2, 2});
}

}  // namespace sectile::test
