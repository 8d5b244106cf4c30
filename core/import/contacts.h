// Faces that cross or overlap.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/kernel.h"
#include "sectile/errors.h"
#include "sectile/solid.h"
#include "selftest/self_test.h"
#include "topology/brep.h"

namespace sectile {

/// The same of faces of a solid.
struct FacePairContact {
  FaceId first, second;
  SelfContact::Kind kind;
  Vec3 where;
};

/// Every two faces that meet in more than a solid's faces do, once each, in ascending order.
std::vector<FacePairContact> face_contacts(const Brep& brep, const Kernel& kernel,
                                           const SelfTestControl& control = {});
/// The same of triangles: FaceId stands for a triangle's face.
std::vector<FacePairContact> face_contacts(const TriangleSurface& surface, const Kernel& kernel,
                                           const SelfTestControl& control = {});

/// "cross", "lie on each other", …
const char* in_words(SelfContact::Kind kind);

/// Throws InvalidSolid if there are any.
void refuse_contacts(const Brep& brep, const Kernel& kernel, const ImportOptions& options);
/// The same of triangles that are faces: `source` has the input's number of each.
void refuse_contacts(const TriangleSurface& surface, std::span<const std::uint32_t> source,
                     const Kernel& kernel, const ImportOptions& options);

}  // namespace sectile
