#include "scene/snapping.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "scene/transforms.h"

namespace sectile::viewer {

namespace {

constexpr double parallel = 1 - 1e-9;

/// A contact that a further move would make.
struct Candidate {
  Snap::Kind kind;
  glm::dvec3 step;      // further than `offset`
  glm::dvec3 from, to;  // where the dragged point stands before the drag, and comes to be
  std::optional<Vec3> local;
  std::array<bool, 3> fixed{true, true, true};
  double cost = 0;
};

int rank(Snap::Kind kind) {
  switch (kind) {
    case Snap::Kind::vertex_vertex:
      return 0;
    case Snap::Kind::edge_edge:
      return 1;
    case Snap::Kind::vertex_edge:
    case Snap::Kind::edge_vertex:
      return 2;
    case Snap::Kind::face_face:
      return 3;
    default:
      return 4;
  }
}

class Search {
 public:
  Search(const glm::dvec3& offset, double reach, const SnapDirections& directions)
      : offset_(offset), reach_(reach) {
    for (const Vec3& d : directions) directions_.push_back(to_glm(d));
  }

  void run(const SnapFeatures& dragged, const SnapFeatures& fixed) {
    const SnapFeatures near_dragged = near(dragged, fixed, offset_);
    const SnapFeatures near_fixed = near(fixed, dragged, -offset_);
    for (const auto& v : near_dragged.vertices) {
      const glm::dvec3 from = to_glm(v.point), now = from + offset_;
      for (const auto& w : near_fixed.vertices)
        point(Snap::Kind::vertex_vertex, from, v.local, to_glm(w.point));
      for (const auto& e : near_fixed.edges)
        if (const auto foot = foot_on(e, now)) point(Snap::Kind::vertex_edge, from, v.local, *foot);
      for (const auto& f : near_fixed.faces)
        plane(Snap::Kind::vertex_face, from, v.local, to_glm(f.point), f, to_glm(f.normal),
              glm::dvec3(0));
    }
    for (const auto& e : near_dragged.edges) edge(e, near_fixed);
    for (const auto& f : near_dragged.faces) face(f, near_fixed);
  }

  const std::optional<Candidate>& best() const { return best_; }

 private:
  /// Only what can come into reach is compared.
  SnapFeatures near(const SnapFeatures& all, const SnapFeatures& other,
                    const glm::dvec3& by) const {
    glm::dvec3 low(1e300), high(-1e300);
    for (const auto& f : other.faces)
      low = glm::min(low, to_glm(f.low)), high = glm::max(high, to_glm(f.high));
    low -= reach_ + by, high += reach_ - by;
    const auto inside = [&](const glm::dvec3& a, const glm::dvec3& b) {
      return glm::all(glm::lessThanEqual(glm::min(a, b), high)) &&
             glm::all(glm::greaterThanEqual(glm::max(a, b), low));
    };
    SnapFeatures kept;
    for (const auto& v : all.vertices)
      if (inside(to_glm(v.point), to_glm(v.point))) kept.vertices.push_back(v);
    for (const auto& e : all.edges)
      if (inside(to_glm(e.from), to_glm(e.to))) kept.edges.push_back(e);
    for (const auto& f : all.faces)
      if (inside(to_glm(f.low), to_glm(f.high))) kept.faces.push_back(f);
    return kept;
  }

  std::optional<glm::dvec3> foot_on(const SnapFeatures::Edge& e, const glm::dvec3& p) const {
    const glm::dvec3 a = to_glm(e.from), d = to_glm(e.to) - a;
    const double t = glm::dot(p - a, d) / glm::dot(d, d);
    if (t < 0 || t > 1) return std::nullopt;
    return a + d * t;
  }

  /// Can the drag go there? The part of the step that it cannot make must be nothing.
  bool allowed(const glm::dvec3& step) const {
    glm::dvec3 rest = step;
    for (const glm::dvec3& d : directions_) rest -= d * glm::dot(rest, d);
    return glm::length(rest) <= 1e-12 * (1 + glm::length(offset_) + glm::length(step));
  }

  void propose(Candidate candidate) {
    candidate.cost = glm::length(candidate.step);
    if (candidate.cost > reach_) return;
    const auto better = [](const Candidate& a, const Candidate& b) {
      return rank(a.kind) != rank(b.kind) ? rank(a.kind) < rank(b.kind) : a.cost < b.cost;
    };
    if (!best_ || better(candidate, *best_)) best_ = candidate;
  }

  void point(Snap::Kind kind, const glm::dvec3& from, const std::optional<Vec3>& local,
             const glm::dvec3& to) {
    const glm::dvec3 step = to - (from + offset_);
    if (allowed(step)) propose({kind, step, from, to, local});
  }

  void edge(const SnapFeatures::Edge& e, const SnapFeatures& fixed) {
    const glm::dvec3 a = to_glm(e.from) + offset_, d = to_glm(e.to) - to_glm(e.from);
    const double length = glm::dot(d, d);
    for (const auto& v : fixed.vertices) {
      const double t = glm::dot(to_glm(v.point) - a, d) / length;
      if (t >= 0 && t <= 1)
        point(Snap::Kind::edge_vertex, a + d * t - offset_, std::nullopt, to_glm(v.point));
    }
    for (const auto& other : fixed.edges) {
      const glm::dvec3 b = to_glm(other.from), c = to_glm(other.to) - b;
      if (std::abs(glm::dot(glm::normalize(c), glm::normalize(d))) < parallel) continue;
      const glm::dvec3 foot = b + c * (glm::dot(a - b, c) / glm::dot(c, c));
      const double t0 = glm::dot(a - b, c) / glm::dot(c, c);
      const double t1 = glm::dot(a + d - b, c) / glm::dot(c, c);
      if (std::max(t0, t1) < 0 || std::min(t0, t1) > 1) continue;  // beside each other
      point(Snap::Kind::edge_edge, to_glm(e.from), e.local, foot);
    }
  }

  /// Moves a point of the dragged solid onto a plane, along the directions that are free, if that
  /// is beside `box`.
  void plane(Snap::Kind kind, const glm::dvec3& from, const Vec3& local, const glm::dvec3& on_plane,
             const SnapFeatures::Face& box, const glm::dvec3& n, const glm::dvec3& dragged_extent) {
    glm::dvec3 free(0);
    for (const glm::dvec3& d : directions_) free += d * glm::dot(n, d);
    const double along = glm::dot(free, n);
    if (along < 1e-6) return;
    const glm::dvec3 now = from + offset_;
    const glm::dvec3 step = free * (glm::dot(on_plane - now, n) / along);
    const glm::dvec3 there = now + step, margin = glm::dvec3(reach_) + dragged_extent;
    if (glm::any(glm::lessThan(there, to_glm(box.low) - margin)) ||
        glm::any(glm::greaterThan(there, to_glm(box.high) + margin)))
      return;
    Candidate made{kind, step, from, there, local};
    for (int i = 0; i < 3; ++i)
      if (std::abs(n[i]) == 1) {
        made.to[i] = on_plane[i];
        for (int j = 0; j < 3; ++j) made.fixed[static_cast<std::size_t>(j)] = j == i;
      }
    propose(made);
  }

  void face(const SnapFeatures::Face& f, const SnapFeatures& fixed) {
    const glm::dvec3 n = to_glm(f.normal), from = to_glm(f.point);
    const glm::dvec3 extent = to_glm(f.high) - to_glm(f.low);
    for (const auto& other : fixed.faces)
      if (glm::dot(n, to_glm(other.normal)) < -parallel)
        plane(Snap::Kind::face_face, from, f.local, to_glm(other.point), other,
              to_glm(other.normal), extent);
    for (const auto& v : fixed.vertices) {
      const SnapFeatures::Face at{v.point, v.point, f.normal, v.point, v.point};
      plane(Snap::Kind::face_vertex, from, f.local, to_glm(v.point), at, n, extent);
    }
  }

  const glm::dvec3 offset_;
  const double reach_;
  std::vector<glm::dvec3> directions_;
  std::optional<Candidate> best_;
};

/// The directions that stay free when a plane holds the solid.
SnapDirections without(const SnapDirections& directions, const glm::dvec3& normal) {
  SnapDirections kept;
  for (const Vec3& direction : directions) {
    glm::dvec3 d = to_glm(direction) - normal * glm::dot(to_glm(direction), normal);
    for (const Vec3& k : kept) d -= to_glm(k) * glm::dot(d, to_glm(k));
    if (glm::length(d) > 1e-6) kept.push_back(from_glm(glm::normalize(d)));
  }
  return kept;
}

}  // namespace

double snapped(double value, double step) {
  if (!(step > 0)) return value;
  // Steps such as 0.1 are meant as decimals: 3 of them are 0.3, not 0.30000000000000004.
  const double per_unit = std::round(1 / step);
  const bool divides = per_unit >= 1 && 1 / per_unit == step;
  const double made =
      divides ? std::round(value * per_unit) / per_unit : std::round(value / step) * step;
  return made == 0 ? 0 : made;
}

Vec3 snapped(const Vec3& value, double step) {
  return {snapped(value.x, step), snapped(value.y, step), snapped(value.z, step)};
}

SnapDirections all_directions() {
  return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
}

std::vector<Snap> snap(const SnapFeatures& dragged, const SnapFeatures& fixed, const Vec3& offset,
                       double reach, const SnapDirections& directions) {
  std::vector<Snap> made;
  glm::dvec3 now = to_glm(offset);
  SnapDirections free = directions;
  while (!free.empty() && made.size() < 3) {
    Search search(now, reach, free);
    search.run(dragged, fixed);
    if (!search.best()) break;
    const Candidate& best = *search.best();
    now += best.step;
    made.push_back(
        {best.kind, from_glm(now), from_glm(best.from), from_glm(best.to), best.local, best.fixed});
    if (rank(best.kind) < rank(Snap::Kind::face_face)) break;  // nothing is left to move
    const double length = glm::length(best.step);
    // The normal of the contact: the only coordinate that is fixed, or the way that it moved.
    glm::dvec3 normal = length > 0 ? best.step / length : glm::dvec3(0);
    for (int i = 0; i < 3; ++i)
      if (best.fixed[static_cast<std::size_t>(i)] &&
          !best.fixed[static_cast<std::size_t>((i + 1) % 3)])
        normal = glm::dvec3(0), normal[i] = 1;
    if (normal == glm::dvec3(0)) break;
    free = without(free, normal);
  }
  return made;
}

}  // namespace sectile::viewer
