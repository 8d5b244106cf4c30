#include "import/contacts.h"

#include <algorithm>
#include <string>
#include <utility>

#include "import/diagnosis.h"
#include "selftest/solid_surface.h"

namespace sectile {

namespace {

Vec3 corner(const Brep& brep, const Geometry& geometry, FaceId f) {
  const HalfEdgeId h = brep.loop_half_edge[brep.outer_loop[f]];
  return geometry.position(brep.point_of(brep.from(h)));
}

// `source` gives the input's number of a face.
template <class Source>
void refuse(const std::vector<FacePairContact>& found, const Source& source) {
  if (found.empty()) return;
  std::vector<FaceContact> contacts;
  contacts.reserve(found.size());
  for (const FacePairContact& c : found) {
    const auto [f, g] = std::minmax({source(c.first), source(c.second)});
    const std::string faces = f == g ? "parts of face " + std::to_string(f)
                                     : "faces " + std::to_string(f) + " and " + std::to_string(g);
    contacts.push_back({f, g, c.where, faces + " " + in_words(c.kind)});
  }
  const auto faces = [](const FaceContact& c) { return std::pair(c.face, c.other); };
  std::stable_sort(contacts.begin(), contacts.end(),
                   [&](const auto& a, const auto& b) { return faces(a) < faces(b); });
  std::string message = contacts.front().what + " near " + in_words(contacts.front().where);
  if (found.size() > 1)
    message += ", and " + std::to_string(found.size() - 1) + " other pairs of faces meet likewise";
  message += "; make solids of the parts and unite them, or repair the mesh";
  throw InvalidSolid(message, std::move(contacts));
}

}  // namespace

std::vector<FacePairContact> face_contacts(const TriangleSurface& surface, const Kernel& kernel,
                                           const SelfTestControl& control) {
  SelfTestControl once = control;
  once.overlaps_once = true;
  std::vector<FacePairContact> found;
  for (const SelfContact& c : self_contacts(surface, kernel, once)) {
    const auto [first, second] = std::minmax(surface.face[c.first], surface.face[c.second]);
    found.push_back({FaceId(first), FaceId(second), c.kind, c.where});
  }
  const auto faces = [](const FacePairContact& c) { return std::pair(c.first, c.second); };
  std::stable_sort(found.begin(), found.end(),
                   [&](const auto& a, const auto& b) { return faces(a) < faces(b); });
  found.erase(std::unique(found.begin(), found.end(),
                          [&](const auto& a, const auto& b) { return faces(a) == faces(b); }),
              found.end());
  return found;
}

std::vector<FacePairContact> face_contacts(const Brep& brep, const Kernel& kernel,
                                           const SelfTestControl& control) {
  std::vector<FaceId> crossing;
  const TriangleSurface surface = surface_of(brep, kernel, crossing);
  if (crossing.empty()) return face_contacts(surface, kernel, control);
  std::vector<FacePairContact> found;  // what lies across their edges is not known
  for (const FaceId f : crossing)
    found.push_back({f, f, SelfContact::Kind::crossing, corner(brep, kernel.geometry(), f)});
  return found;
}

const char* in_words(SelfContact::Kind kind) {
  switch (kind) {
    case SelfContact::Kind::crossing:
      return "cross each other";
    case SelfContact::Kind::overlap:
      return "lie on each other";
    case SelfContact::Kind::wedges:
      break;
  }
  return "meet in an edge around which material overlaps";
}

void refuse_contacts(const Brep& brep, const Kernel& kernel, const ImportOptions& options) {
  refuse(face_contacts(brep, kernel, {options.cancel, options.progress}),
         [&](FaceId f) { return brep.source[f].face; });
}

void refuse_contacts(const TriangleSurface& surface, std::span<const std::uint32_t> source,
                     const Kernel& kernel, const ImportOptions& options) {
  refuse(face_contacts(surface, kernel, {options.cancel, options.progress}),
         [&](FaceId f) { return source[f.value()]; });
}

}  // namespace sectile
