#include "scene/primitives/parameters.h"

namespace sectile::viewer {
namespace {

constexpr PrimitiveField fields[] = {segments_field};

Solid solid(const Primitive& p) {
  require_faces(2 * std::uint64_t{p.segments} * p.profile.outer.size());
  return revolve(p.profile, p.segments);
}

void begin(Primitive& p) {
  // The cross-section of a ring.
  p.profile.outer = {{0.5, 0}, {1, 0}, {1, 0.5}, {0.75, 1}, {0.5, 1}};
}

}  // namespace

extern const PrimitiveKind revolution_kind{"revolution", fields, solid, ProfileUse::turned, begin};

}  // namespace sectile::viewer
