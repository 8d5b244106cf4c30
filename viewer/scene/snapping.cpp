#include "scene/snapping.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "scene/transforms.h"

namespace sectile::viewer {

namespace {

constexpr double parallel = 1 - 1e-9;
// Comparisons for one search: some milliseconds.
constexpr int most_comparisons = 200'000;

using CornerIndex = SnapFeatures::CornerIndex;

/// Up to three corners of a solid.
struct Corners {
  std::array<CornerIndex, 3> at{};
  std::size_t count = 0;
};
Corners corners_of(const SnapFeatures::Vertex& v) {
  return {{v.corner}, 1};
}
Corners corners_of(const SnapFeatures::Edge& e) {
  return {{e.corners[0], e.corners[1]}, 2};
}
Corners corners_of(const SnapFeatures::Face& f) {
  return {f.corners, 3};
}

/// A contact that a further move would make.
struct Candidate {
  Snap::Kind kind;
  glm::dvec3 step;      // further than `offset`
  glm::dvec3 from, to;  // where the dragged point stands before the drag, and comes to be
  std::uint32_t part = 0;
  Corners moved{}, on{};
  Coordinates fixed{true, true, true};
  bool is_expressible = true;
  std::size_t target = 0;
  const SnapFeatures::Edge* edge = nullptr;  // of the solid standing still
  const SnapFeatures::Face* face = nullptr;
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

/// The axis that a direction is, or -1.
int axis_of(const glm::dvec3& d) {
  for (int i = 0; i < 3; ++i)
    if (d[(i + 1) % 3] == 0 && d[(i + 2) % 3] == 0) return i;
  return -1;
}

class Search {
 public:
  Search(const glm::dvec3& offset, double reach, const SnapDirections& directions)
      : offset_(offset), reach_(reach) {
    for (const Vec3& d : directions) directions_.push_back(to_glm(d));
  }

  void run(const SnapFeatures& dragged, const SnapTargets& fixed, std::size_t target) {
    target_ = target;
    all_ = {fixed.vertices().extent(), fixed.faces().extent()};
    for (const auto& v : dragged.vertices) vertex(v, fixed);
    for (const auto& e : dragged.edges) edge(e, fixed);
    for (const auto& f : dragged.faces) face(f, fixed);
  }

  const std::optional<Candidate>& best() const { return best_; }
  bool gave_up() const { return comparisons_ > most_comparisons; }

 private:
  /// Where a dragged thing stands after the offset, and twice the reach around: nearer than the
  /// reach is nearer than that in all coordinates. The second half is for what was rounded.
  template <class Visit>
  void near(const glm::dvec3& a, const glm::dvec3& b, const BoxSearch& things, Visit&& visit) {
    const Extent place = extent_around(a + offset_, b + offset_, 2 * reach_);
    if (gave_up() || !(place.meets(all_[0]) || place.meets(all_[1]))) return;
    ++comparisons_;
    things.near(place, [&](std::uint32_t i) {
      if (++comparisons_ <= most_comparisons) visit(i);
    });
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
    candidate.target = target_;
    if (candidate.cost > reach_) return;
    const auto better = [](const Candidate& a, const Candidate& b) {
      return rank(a.kind) != rank(b.kind) ? rank(a.kind) < rank(b.kind) : a.cost < b.cost;
    };
    if (!best_ || better(candidate, *best_)) best_ = candidate;
  }

  void point(Snap::Kind kind, const glm::dvec3& from, const Corners& moved, std::uint32_t part,
             const glm::dvec3& to, const SnapFeatures::Vertex& on) {
    Candidate made{kind, to - (from + offset_), from, to, part, moved, corners_of(on)};
    if (allowed(made.step)) propose(made);
  }

  void point_on_edge(Snap::Kind kind, const glm::dvec3& from, const Corners& moved,
                     std::uint32_t part, const glm::dvec3& to, const SnapFeatures::Edge& on) {
    Candidate made{kind, to - (from + offset_), from, to, part, moved};
    if (!allowed(made.step)) return;
    made.edge = &on;
    const int along = axis_of(to_glm(on.to) - to_glm(on.from));
    made.is_expressible = along >= 0;
    if (along >= 0) {
      made.on = corners_of(on);
      made.fixed[static_cast<std::size_t>(along)] = false;
    }
    propose(made);
  }

  void vertex(const SnapFeatures::Vertex& v, const SnapTargets& fixed) {
    const glm::dvec3 from = to_glm(v.point);
    const SnapFeatures& all = fixed.features();
    near(from, from, fixed.vertices(), [&](std::uint32_t i) {
      point(Snap::Kind::vertex_vertex, from, corners_of(v), v.part, to_glm(all.vertices[i].point),
            all.vertices[i]);
    });
    near(from, from, fixed.edges(), [&](std::uint32_t i) {
      if (const auto foot = foot_on(all.edges[i], from + offset_))
        point_on_edge(Snap::Kind::vertex_edge, from, corners_of(v), v.part, *foot, all.edges[i]);
    });
    near(from, from, fixed.faces(), [&](std::uint32_t i) {
      const auto& f = all.faces[i];
      plane(Snap::Kind::vertex_face, from, corners_of(v), v.part, to_glm(f.point), corners_of(f), f,
            to_glm(f.normal), glm::dvec3(0), &f);
    });
  }

  void edge(const SnapFeatures::Edge& e, const SnapTargets& fixed) {
    const glm::dvec3 from = to_glm(e.from), d = to_glm(e.to) - from, a = from + offset_;
    const double length = glm::dot(d, d);
    const SnapFeatures& all = fixed.features();
    near(from, to_glm(e.to), fixed.vertices(), [&](std::uint32_t i) {
      const double t = glm::dot(to_glm(all.vertices[i].point) - a, d) / length;
      if (t >= 0 && t <= 1) edge_onto_vertex(e, d, a + d * t - offset_, all.vertices[i]);
    });
    near(from, to_glm(e.to), fixed.edges(), [&](std::uint32_t i) {
      const auto& other = all.edges[i];
      const glm::dvec3 b = to_glm(other.from), c = to_glm(other.to) - b;
      if (std::abs(glm::dot(glm::normalize(c), glm::normalize(d))) < parallel) return;
      const double t0 = glm::dot(a - b, c) / glm::dot(c, c);
      const double t1 = glm::dot(a + d - b, c) / glm::dot(c, c);
      if (std::max(t0, t1) < 0 || std::min(t0, t1) > 1) return;  // beside each other
      point_on_edge(Snap::Kind::edge_edge, from, corners_of(e), e.part, b + c * t0, other);
    });
  }

  // Any point of an edge along an axis has the two coordinates that count; on a slanted one there
  // may be no double.
  void edge_onto_vertex(const SnapFeatures::Edge& e, const glm::dvec3& direction,
                        const glm::dvec3& from, const SnapFeatures::Vertex& onto) {
    const int along = axis_of(direction);
    const glm::dvec3 to = to_glm(onto.point);
    Candidate made{Snap::Kind::edge_vertex, to - (from + offset_), from, to, e.part};
    if (!allowed(made.step)) return;
    made.on = corners_of(onto);
    made.is_expressible = along >= 0;
    if (along >= 0) {
      made.fixed[static_cast<std::size_t>(along)] = false;
      made.moved = corners_of(e);
      made.from = to_glm(e.from);
    }
    propose(made);
  }

  /// Moves a point of the dragged solid onto a plane, along the directions that are free, if that
  /// is beside `box`.
  void plane(Snap::Kind kind, const glm::dvec3& from, const Corners& moved, std::uint32_t part,
             const glm::dvec3& on_plane, const Corners& on, const SnapFeatures::Face& box,
             const glm::dvec3& n, const glm::dvec3& dragged_extent,
             const SnapFeatures::Face* shown) {
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
    Candidate made{kind, step, from, there, part, moved};
    made.face = shown;
    const int axis = axis_of(n);
    made.is_expressible = axis >= 0;
    if (axis >= 0) {
      made.on = on;
      made.to[axis] = on_plane[axis];
      made.fixed = {axis == 0, axis == 1, axis == 2};
    }
    propose(made);
  }

  void face(const SnapFeatures::Face& f, const SnapTargets& fixed) {
    const glm::dvec3 n = to_glm(f.normal), from = to_glm(f.point);
    const glm::dvec3 extent = to_glm(f.high) - to_glm(f.low);
    const SnapFeatures& all = fixed.features();
    near(to_glm(f.low), to_glm(f.high), fixed.faces(), [&](std::uint32_t i) {
      const auto& other = all.faces[i];
      if (glm::dot(n, to_glm(other.normal)) < -parallel)
        plane(Snap::Kind::face_face, from, corners_of(f), f.part, to_glm(other.point),
              corners_of(other), other, to_glm(other.normal), extent, &other);
    });
    near(to_glm(f.low), to_glm(f.high), fixed.vertices(), [&](std::uint32_t i) {
      const auto& v = all.vertices[i];
      const SnapFeatures::Face at{v.point, f.normal, v.point, v.point};
      plane(Snap::Kind::face_vertex, from, corners_of(f), f.part, to_glm(v.point), corners_of(v),
            at, n, extent, nullptr);
    });
  }

  const glm::dvec3 offset_;
  const double reach_;
  std::vector<glm::dvec3> directions_;
  std::optional<Candidate> best_;
  std::size_t target_ = 0;
  std::array<Extent, 2> all_{};  // of the target: its vertices, its faces
  int comparisons_ = 0;
};

std::vector<ExactCorner> exact_corners(const SnapFeatures& features, const Corners& corners) {
  std::vector<ExactCorner> made;
  for (std::size_t i = 0; i < corners.count; ++i) made.push_back(features.corners[corners.at[i]]);
  return made;
}

Snap snap_of(const Candidate& best, const glm::dvec3& offset, const SnapFeatures& dragged,
             const SnapTargets& target) {
  Snap made;
  made.kind = best.kind;
  made.offset = from_glm(offset);
  made.from = from_glm(best.from);
  made.to = from_glm(best.to);
  made.part = best.part;
  made.moved = exact_corners(dragged, best.moved);
  made.on = exact_corners(target.features(), best.on);
  made.on_place = target.place();
  made.fixed = best.fixed;
  made.is_expressible = best.is_expressible;
  made.target = best.target;
  if (best.edge) made.shown = {best.edge->from, best.edge->to};
  if (best.face) made.shown = target.outline(*best.face);
  return made;
}

/// The normal of a contact of planes: the only coordinate that is fixed, or the way that it moved.
glm::dvec3 normal_of(const Candidate& best) {
  for (int i = 0; i < 3; ++i)
    if (best.fixed == Coordinates{i == 0, i == 1, i == 2}) {
      glm::dvec3 normal(0);
      normal[i] = 1;
      return normal;
    }
  const double length = glm::length(best.step);
  return length > 0 ? best.step / length : glm::dvec3(0);
}

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

Snaps snap(const SnapFeatures& dragged, const std::vector<const SnapTargets*>& fixed,
           const Vec3& offset, double reach, const SnapDirections& directions) {
  Snaps made;
  glm::dvec3 now = to_glm(offset);
  SnapDirections free = directions;
  while (!free.empty() && made.contacts.size() < 3) {
    Search search(now, reach, free);
    for (std::size_t i = 0; i < fixed.size(); ++i) search.run(dragged, *fixed[i], i);
    if (search.gave_up()) return {{}, true};
    if (!search.best()) break;
    const Candidate& best = *search.best();
    now += best.step;
    made.contacts.push_back(snap_of(best, now, dragged, *fixed[best.target]));
    if (rank(best.kind) < rank(Snap::Kind::face_face)) break;  // nothing is left to move
    const glm::dvec3 normal = normal_of(best);
    if (normal == glm::dvec3(0)) break;
    free = without(free, normal);
  }
  return made;
}

}  // namespace sectile::viewer
