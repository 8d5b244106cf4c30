// The Boolean operations: the phases of the algorithm, in order.
#include "sectile/boolean.h"

#include <algorithm>

#include "boolean/cleanup.h"
#include "boolean/components.h"
#include "boolean/face_parts.h"
#include "boolean/gluing.h"
#include "boolean/joining.h"
#include "boolean/neighborhoods.h"
#include "boolean/null_edges.h"
#include "boolean/reduction/reduction.h"
#include "boolean/run.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

FacePairs overlapping_faces(const SolidData& a, const SolidData& b) {
  FacePairs pairs;
  BoxTree::overlaps(a.tree(), b.tree(), [&](std::uint32_t f, std::uint32_t g) {
    pairs.push_back({FaceId(f), FaceId(g)});
  });
  return pairs;
}

std::vector<FaceId> faces_of(const FacePairs& pairs, bool second) {
  std::vector<FaceId> faces;
  faces.reserve(pairs.size());
  for (const auto& [f, g] : pairs) faces.push_back(second ? g : f);
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

}  // namespace

FaceId loaded_face(const Patch& patch, FaceId face) {
  if (patch.whole) return face;
  const auto at = std::lower_bound(patch.face_in_solid.begin(), patch.face_in_solid.end(), face);
  return FaceId(static_cast<std::size_t>(at - patch.face_in_solid.begin()));
}

void load(Workspace& w, const SolidData& a, const SolidData& b, FacePairs& pairs) {
  pairs = overlapping_faces(a, b);
  w.patch[0] = load_patch(a, faces_of(pairs, false), w.geometry);
  w.patch[1] = load_patch(b, faces_of(pairs, true), w.geometry);
  w.kernel = std::make_unique<Kernel>(w.geometry);
  for (Patch& patch : w.patch) complete_patch(patch, w.geometry, *w.kernel);
  for (auto& [f, g] : pairs) {
    f = loaded_face(w.patch[0], f);
    g = loaded_face(w.patch[1], g);
  }
  std::sort(pairs.begin(), pairs.end());
}

void cut(Workspace& w, const FacePairs& pairs, std::span<const Operation> wanted) {
  reduce(w, pairs);
  find_neighborhoods(w, wanted);
  find_sites(w);
  subdivide_edges(w);
  order_cuts(w);
  insert_null_edges(w);
  join_null_edges(w);
  settle_face_parts(w);
}

Solid assemble(Workspace& w, Operation operation, std::size_t index) {
  const FaceLabels kept = find_kept(w, operation);
  Glued glued = glue(w, operation, w.wedges[index], kept);
  clean_up(glued);
  return Solid(std::shared_ptr<const SolidData>(std::move(glued.data)));
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
  Workspace w(options);
  FacePairs pairs;
  load(w, *a.data(), *b.data(), pairs);
  const Operation wanted[] = {operation};
  cut(w, pairs, wanted);
  return assemble(w, operation, 0);
}

}  // namespace sectile
