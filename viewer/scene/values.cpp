// Equality and names of what a scene is made of.
#include <algorithm>
#include <cctype>

#include "scene/primitive_kind.h"

namespace sectile::viewer {

namespace {

bool same_points(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Vec2& p, const Vec2& q) { return p.x == q.x && p.y == q.y; });
}

bool same_profile(const Profile& a, const Profile& b) {
  return same_points(a.outer, b.outer) &&
         std::equal(a.holes.begin(), a.holes.end(), b.holes.begin(), b.holes.end(), same_points);
}

bool same_mesh(const PolygonMesh& a, const PolygonMesh& b) {
  return a.positions == b.positions && a.face_sizes == b.face_sizes && a.indices == b.indices;
}

struct DefaultName {
  std::string operator()(const Primitive& p) const {
    std::string name(p.kind->name);
    name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    return name;
  }
  std::string operator()(const Imported& i) const {
    const std::string stem = i.path.stem().string();
    return stem.empty() ? "Mesh" : stem;
  }
  std::string operator()(const BooleanNode& b) const {
    switch (b.operation) {
      case Operation::unite:
        return "Union";
      case Operation::intersect:
        return "Intersection";
      case Operation::subtract:
        return "Difference";
    }
    return "Operation";
  }
  std::string operator()(const SplitNode& s) const { return s.above ? "Above" : "Below"; }
  std::string operator()(const Group&) const { return "Group"; }
  std::string operator()(const Pattern& p) const {
    switch (p.kind) {
      case Pattern::Kind::linear:
        return "Linear array";
      case Pattern::Kind::polar:
        return "Polar array";
      case Pattern::Kind::path:
        return "Array along a path";
      case Pattern::Kind::mirror:
        return "Mirror";
    }
    return "Pattern";
  }
};

}  // namespace

bool operator==(const Primitive& a, const Primitive& b) {
  return a.kind == b.kind && a.size == b.size && a.radius == b.radius &&
         a.top_radius == b.top_radius && a.minor_radius == b.minor_radius && a.height == b.height &&
         a.segments == b.segments && a.rings == b.rings && same_profile(a.profile, b.profile);
}

bool operator==(const Imported& a, const Imported& b) {
  if (a.path != b.path) return false;
  return a.mesh == b.mesh || (a.mesh && b.mesh && same_mesh(*a.mesh, *b.mesh));
}

bool operator==(const SplitNode& a, const SplitNode& b) {
  return a.above == b.above && a.plane.a == b.plane.a && a.plane.b == b.plane.b &&
         a.plane.c == b.plane.c && a.plane.d == b.plane.d;
}

std::string default_name(const Node& node) {
  return std::visit(DefaultName(), node.what);
}

}  // namespace sectile::viewer
