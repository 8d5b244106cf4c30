// The Boolean operations: the phases of the algorithm, in order.
#include "sectile/boolean.h"

#include <algorithm>

#include "boolean/cleanup.h"
#include "boolean/complement.h"
#include "boolean/components.h"
#include "boolean/face_parts.h"
#include "boolean/gluing.h"
#include "boolean/joining.h"
#include "boolean/neighborhoods.h"
#include "boolean/null_edges.h"
#include "boolean/reduction/reduction.h"
#include "boolean/report.h"
#include "boolean/run.h"
#include "boolean/save_operands.h"
#include "sectile/errors.h"
#include "storage/splice.h"
#include "topology/links.h"

namespace sectile {
namespace {

// Cancels if asked to, and tells how far the work is.
void step(const Workspace& w, double done) {
  w.check_cancelled();
  if (w.options.progress) w.options.progress(done);
}

void check(const Workspace& w, const char* phase) {
  if (!w.options.validate) return;
  for (const Patch& patch : w.patch)
    if (const auto found = broken_links(patch.brep, patch.unbounded); !found.empty())
      throw InternalError(std::string("after ") + phase + ": " + found.front());
}

bool operands_touch_themselves(const Workspace& w) {
  return std::any_of(std::begin(w.patch), std::end(w.patch), [](const Patch& patch) {
    return patch.solid && patch.solid->touches_itself();
  });
}

}  // namespace

void cut(Workspace& w, const FacePairs& pairs, std::span<const Operation> wanted) {
  const bool observed = w.options.observer && !wanted.empty();
  step(w, 0.1);
  reduce(w, pairs);
  if (observed) report_reduction(w);
  step(w, 0.4);
  find_neighborhoods(w, wanted);
  if (observed) report_neighborhoods(w, wanted[0]);
  find_sites(w);
  subdivide_edges(w);
  check(w, "subdivision");
  bridge_touching_corners(w);
  order_cuts(w);
  insert_null_edges(w);
  check(w, "null edges");
  if (observed) report_null_edges(w);
  step(w, 0.5);
  join_null_edges(w);
  if (observed) report_joining(w);
  settle_face_parts(w);
  check(w, "settling the parts of faces");
  step(w, 0.6);
}

Solid assemble(Workspace& w, Operation operation, std::size_t index) {
  const FaceLabels kept = find_kept(w, operation);
  if (w.options.observer) report_components(w, kept, operation);
  step(w, 0.7);
  Glued glued = glue(w, operation, w.wedges[index], kept);
  if (w.options.observer) report_gluing(w, w.wedges[index]);
  step(w, 0.9);
  clean_up(glued.brep, glued.geometry, glued.seams);
  const bool touches = !glued.slots.empty() && operands_touch_themselves(w);
  Solid result(splice(std::move(glued.slots),
                      {std::move(glued.brep), std::move(glued.geometry), std::move(glued.outside)},
                      touches));
  if (w.options.validate)
    if (const auto found = broken_links(result.data()->brep(), false); !found.empty())
      throw InternalError("the result is not legal: " + found.front());
  if (w.options.observer) report_cleanup(w, result);
  step(w, 1.0);
  return result;
}

Solid boolean(const Solid& a, const Solid& b, Operation operation) {
  return boolean(a, b, operation, BooleanOptions{});
}

Solid boolean(const Solid& a, const Solid& b, Operation operation, const BooleanOptions& options) {
  if (a.is_empty() || b.is_empty()) {
    if (operation == Operation::intersect) return Solid();
    if (operation == Operation::unite && a.is_empty()) return b;
    return a;
  }
  try {
    Workspace w(options);
    FacePairs pairs;
    load(w, operand(a, options),
         operation == Operation::subtract ? reversible(operand(b, options)) : operand(b, options),
         pairs);
    const Operation wanted[] = {operation};
    cut(w, pairs, wanted);
    return assemble(w, operation, 0);
  } catch (const InternalError& error) {
    throw InternalError(std::string(error.what()) + "; " + save_operands(a, b));
  }
}

}  // namespace sectile
