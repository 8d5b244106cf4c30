// The Boolean operations: the phases of the algorithm, in order.
#include "boolean/boolean.h"

#include <algorithm>
#include <optional>

#include "boolean/check_links.h"
#include "boolean/cleanup/cleanup.h"
#include "boolean/complement.h"
#include "boolean/components/components.h"
#include "boolean/gluing/gluing.h"
#include "boolean/loading/load.h"
#include "boolean/report/report.h"
#include "boolean/same_faces.h"
#include "boolean/save_operands.h"
#include "sectile/errors.h"
#include "storage/shared_points.h"
#include "storage/splice.h"
#include "topology/links.h"

namespace sectile {
namespace {

// Cancels if asked to, and tells how far the work is.
void step(const Workspace& w, double done) {
  w.check_cancelled();
  if (w.options.progress) w.options.progress(done);
}

bool is_observed(const Workspace& w, const Wanted& wanted) {
  return w.options.observer && !wanted.operations.empty();
}

bool operands_touch_themselves(const Workspace& w) {
  return std::any_of(w.patch.begin(), w.patch.end(), [](const Patch& patch) {
    return patch.solid && patch.solid->touches_itself();
  });
}

// What was loaded and the blocks, which are made anew with it, each have points of their own: a
// place of several vertices may have several.
bool places_have_points_of_their_own(const Workspace& w) {
  return std::any_of(w.patch.begin(), w.patch.end(), [](const Patch& patch) {
    return patch.solid && !patch.whole && patch.solid->touches_itself();
  });
}

// The glued part, cleaned up, together with the blocks that are shared.
Solid solid_of(const Workspace& w, Glued glued) {
  if (places_have_points_of_their_own(w)) {
    w.kernel->refresh();  // gluing added points and planes
    share_points(glued.brep, w.tests());
  }
  std::vector<FaceId> with_kept_loops;
  for (const KeptLoops& kept : glued.kept_loops) with_kept_loops.push_back(kept.face);
  clean_up(glued.brep, w.geometry, glued.seams, with_kept_loops);
  for (std::size_t i = 0; i < with_kept_loops.size(); ++i)
    glued.kept_loops[i].face = with_kept_loops[i];
  const bool touches = !glued.shared.slots.empty() && operands_touch_themselves(w);
  Solid solid(splice(
      std::move(glued.shared),
      {std::move(glued.brep), w.geometry, std::move(glued.outside), std::move(glued.kept_loops)},
      touches));
  if (w.options.validate)
    if (const auto found = broken_links(solid.data()->brep(), false); !found.empty())
      throw InternalError("the result is not legal: " + found.front());
  return solid;
}

}  // namespace

CutBoundaries cut(Workspace& w, const FacePairs& pairs, const Wanted& wanted) {
  step(w, 0.1);
  Contacts contacts = reduce(w, pairs);
  if (is_observed(w, wanted)) report_reduction(w, contacts);
  return cut_at(w, std::move(contacts), wanted);
}

CutBoundaries cut_at(Workspace& w, Contacts found, const Wanted& wanted) {
  const bool observed = is_observed(w, wanted);
  CutBoundaries result{std::move(found), {}, {}};
  auto& [contacts, neighborhoods, joined] = result;

  step(w, 0.4);
  neighborhoods = find_neighborhoods(w, contacts, wanted);
  if (observed) report_neighborhoods(w, contacts, neighborhoods, wanted.operations[0]);

  const CutPlan plan = plan_cuts(w, neighborhoods);
  const Cuts cuts = insert_null_edges(w, contacts, neighborhoods, plan);
  check_links(w, "null edges");
  if (observed) report_null_edges(w, contacts, neighborhoods, cuts);

  step(w, 0.5);
  joined = join_null_edges(w, neighborhoods, cuts);
  check_links(w, "joining");
  if (observed) report_joining(w, contacts, neighborhoods, joined);
  step(w, 0.6);
  return result;
}

Solid assemble(Workspace& w, const CutBoundaries& boundaries, Operation operation,
               std::size_t number) {
  const auto& [contacts, neighborhoods, joined] = boundaries;
  return assemble(w, boundaries, find_kept(w, contacts, neighborhoods, joined, operation),
                  operation, number);
}

Solid assemble(Workspace& w, const CutBoundaries& boundaries, const FaceLabels& kept,
               Operation operation, std::size_t number) {
  const auto& [contacts, neighborhoods, joined] = boundaries;
  const Wedges& wedges = neighborhoods.wedges[number];
  if (w.options.observer) report_components(w, kept, operation);

  // Several results share what is left after the cut.
  const auto assembled = [&, parts = double(neighborhoods.wedges.size())](double done) {
    step(w, 0.6 + 0.4 * ((double(number) + done) / parts));
  };
  assembled(0.25);
  Glued glued = glue(w, operation, neighborhoods, wedges, joined, kept);
  if (w.options.observer) report_gluing(w, contacts, neighborhoods, wedges.pairs);

  assembled(0.75);
  Solid result = solid_of(w, std::move(glued));
  if (w.options.observer) report_cleanup(w, result);
  assembled(1);
  return result;
}

Solid boolean(const Solid& a, const Solid& b, Operation operation) {
  return boolean(a, b, operation, BooleanOptions{});
}

namespace {

// Numbers of faces and boxes tell nearly all others apart.
bool are_the_same(const SolidData& a, const SolidData& b, const BooleanOptions& options) {
  if (&a == &b) return true;
  if (a.face_count() != b.face_count()) return false;
  const Box &of_a = a.slot_tree().bounds(), &of_b = b.slot_tree().bounds();
  return std::ranges::equal(of_a.low, of_b.low) && std::ranges::equal(of_a.high, of_b.high) &&
         have_same_faces(a, b, options.cancel);
}

// The result, if nothing has to be cut.
std::optional<Solid> without_cutting(const Solid& a, const Solid& b, Operation operation,
                                     const BooleanOptions& options) {
  if (a.is_empty() || b.is_empty()) {
    if (operation == Operation::intersect) return Solid();
    if (operation == Operation::unite && a.is_empty()) return b;
    return a;
  }
  // Whoever follows the phases sees how it would be.
  if (!options.observer && are_the_same(operand(a, options), operand(b, options), options))
    return operation == Operation::subtract ? Solid() : a;
  return {};
}

}  // namespace

Solid boolean(const Solid& a, const Solid& b, Operation operation, const BooleanOptions& options) {
  std::optional<Solid> known = without_cutting(a, b, operation, options);
  if (!known) return boolean_by_cutting(a, b, operation, options);
  if (options.progress) options.progress(1);
  return *std::move(known);
}

namespace {

// Where pairs that were left out are needed, none are left out.
Solid cut_and_assembled(const SolidData& a, const SolidData& b, Operation operation,
                        const BooleanOptions& options) {
  const Operation wanted[] = {operation};
  const auto attempt = [&](bool all_pairs) {
    Workspace w(options);
    FacePairs pairs;
    load(w, a, b, pairs, {wanted, false, all_pairs});
    try {
      return std::optional(assemble(w, cut(w, pairs, {wanted}), operation, 0));
    } catch (const NeedsAllPairs&) {
      if (w.crowded_lines.empty() && w.crowded_points.empty() && w.common_faces.empty()) throw;
      return std::optional<Solid>();
    }
  };
  std::optional<Solid> result = attempt(false);
  return result ? *std::move(result) : *attempt(true);
}

}  // namespace

Solid boolean_by_cutting(const Solid& a, const Solid& b, Operation operation,
                         const BooleanOptions& options) {
  try {
    const SolidData& given = operand(b, options);
    const SolidData& of_b =
        operation == Operation::subtract ? as_observed(reversible(given), options) : given;
    return cut_and_assembled(operand(a, options), of_b, operation, options);
  } catch (const InternalError& error) {
    throw InternalError(std::string(error.what()) + "; " + save_operands(a, b));
  }
}

}  // namespace sectile
