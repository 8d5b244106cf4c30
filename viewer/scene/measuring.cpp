#include "scene/measuring.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "scene/transforms.h"

namespace sectile::viewer {
namespace {

constexpr double parallel = 1e-9;  // sine of the angle up to which it is called so
constexpr double roundness = 1e-6;
constexpr double longest_side = 1.22;  // of the radius: longer ones cut across an arc

using Kind = Measured::Kind;
using Point = glm::dvec3;

struct Segment {
  Point from, way;
  double length() const { return glm::length(way); }
  Point direction() const { return way / length(); }
};
Segment segment_of(const Measured& edge) {
  return {to_glm(edge.from), to_glm(edge.to) - to_glm(edge.from)};
}

double degrees_between(const Point& a, const Point& b) {
  return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

Point nearest_on(const Segment& s, const Point& p) {
  const double square = glm::dot(s.way, s.way);
  return s.from +
         s.way * (square > 0 ? glm::clamp(glm::dot(p - s.from, s.way) / square, 0.0, 1.0) : 0);
}

/// The nearest points of two segments: by turns, which comes to rest after two for those that are
/// parallel and is exact where the lines' own nearest points lie within.
std::pair<Point, Point> nearest(const Segment& a, const Segment& b) {
  const Point w = a.from - b.from;
  const double aa = glm::dot(a.way, a.way), bb = glm::dot(b.way, b.way),
               ab = glm::dot(a.way, b.way);
  const double aw = glm::dot(a.way, w), bw = glm::dot(b.way, w), rest = aa * bb - ab * ab;
  const double t = rest > parallel * aa * bb ? glm::clamp((ab * bw - bb * aw) / rest, 0.0, 1.0) : 0;
  const Point on_b = nearest_on(b, a.from + t * a.way);
  const Point on_a = nearest_on(a, on_b);
  return {on_a, nearest_on(b, on_a)};
}

class Facts {
 public:
  void length(const std::string& name, double value) {
    made_.facts.push_back({name, value, false});
  }
  void angle(const std::string& name, double value) { made_.facts.push_back({name, value, true}); }
  void distance(const Point& a, const Point& b) {
    length("Distance", glm::distance(a, b));
    const Point d = b - a;
    for (int i = 0; i < 3; ++i)
      if (std::abs(d[i]) > 1e-12 * glm::length(d)) length(std::string("d") + "xyz"[i], d[i]);
    made_.shown = {from_glm(a), from_glm(b)};
  }
  Measurement take() { return std::move(made_); }

 private:
  Measurement made_;
};

Measurement with_vertex(const Point& p, const Measured& other) {
  Facts facts;
  if (other.kind == Kind::vertex) {
    facts.distance(p, to_glm(other.point));
  } else if (other.kind == Kind::edge) {
    facts.distance(p, nearest_on(segment_of(other), p));
  } else {
    const Point n = to_glm(other.normal);
    facts.distance(p, p - n * glm::dot(p - to_glm(other.point), n));
  }
  return facts.take();
}

Measurement of_edges(const Segment& a, const Segment& b) {
  Facts facts;
  const double angle = degrees_between(a.way, b.way);
  const auto [p, q] = nearest(a, b);
  facts.distance(p, q);
  facts.angle("Angle", std::min(angle, 180 - angle));
  return facts.take();
}

Measurement of_edge_and_face(const Segment& edge, const Measured& face) {
  Facts facts;
  const Point n = to_glm(face.normal), to_plane = n * glm::dot(to_glm(face.point) - edge.from, n);
  const double slope = std::abs(glm::dot(edge.direction(), n));
  if (slope < parallel) facts.distance(edge.from, edge.from + to_plane);
  facts.angle("Angle", glm::degrees(std::asin(std::min(1.0, slope))));
  return facts.take();
}

Measurement of_faces(const Measured& a, const Measured& b) {
  Facts facts;
  const Point n = to_glm(a.normal), m = to_glm(b.normal), p = to_glm(a.point);
  if (glm::length(glm::cross(n, m)) < parallel)
    facts.distance(p, p + n * glm::dot(to_glm(b.point) - p, n));
  // Between the two surfaces, as between the pages of a book: 180 when they are level.
  facts.angle("Angle", 180 - degrees_between(n, m));
  return facts.take();
}

using Neighbours = std::map<std::array<double, 3>, std::vector<Vec3>>;

std::array<double, 3> key_of(const Vec3& p) {
  return {p.x, p.y, p.z};
}

std::optional<Circle> circle_of(const Point& p, const Point& q, const Point& r) {
  const Point u = q - p, v = r - p, n = glm::cross(u, v);
  const double square = glm::dot(n, n);
  if (square <= 1e-24 * glm::dot(u, u) * glm::dot(v, v)) return std::nullopt;
  const Point to_centre =
      (glm::cross(n, u) * glm::dot(v, v) + glm::cross(v, n) * glm::dot(u, u)) / (2 * square);
  Circle made;
  made.centre = from_glm(p + to_centre);
  made.normal = from_glm(n / std::sqrt(square));
  made.radius = glm::length(to_centre);
  return made;
}

bool is_side(const Circle& circle, const Vec3& a, const Vec3& b) {
  return glm::distance(to_glm(a), to_glm(b)) <= longest_side * circle.radius;
}

bool lies_on(const Circle& circle, const Point& p) {
  const Point away = p - to_glm(circle.centre);
  return std::abs(glm::length(away) - circle.radius) <= roundness * circle.radius &&
         std::abs(glm::dot(away, to_glm(circle.normal))) <= roundness * circle.radius;
}

/// Corners that follow `at`, coming from `before`, until the chain ends or reaches `end`.
std::size_t walk(const Circle& circle, const Neighbours& neighbours, Vec3 before, Vec3 at,
                 const Vec3& end, bool& closed) {
  std::size_t count = 0;
  for (const std::size_t most = neighbours.size(); count <= most; ++count) {
    const auto& around = neighbours.at(key_of(at));
    const auto next = std::find_if(around.begin(), around.end(), [&](const Vec3& p) {
      return p != before && is_side(circle, at, p) && lies_on(circle, to_glm(p));
    });
    if (next == around.end()) return count;
    if (*next == end) {
      closed = true;
      return count;
    }
    before = at, at = *next;
  }
  return count;
}

}  // namespace

Measurement measured(const Measured& thing) {
  Facts facts;
  if (thing.kind == Kind::vertex)
    for (int i = 0; i < 3; ++i) facts.length(std::string(1, "xyz"[i]), to_glm(thing.point)[i]);
  if (thing.kind == Kind::edge) facts.length("Length", segment_of(thing).length());
  Measurement made = facts.take();
  if (thing.kind == Kind::edge) made.shown = {thing.from, thing.to};
  return made;
}

Measurement measured(const Measured& a, const Measured& b) {
  if (a.kind == Kind::vertex) return with_vertex(to_glm(a.point), b);
  if (b.kind == Kind::vertex) return with_vertex(to_glm(b.point), a);
  if (a.kind == Kind::edge && b.kind == Kind::edge) return of_edges(segment_of(a), segment_of(b));
  if (a.kind == Kind::edge) return of_edge_and_face(segment_of(a), b);
  if (b.kind == Kind::edge) return of_edge_and_face(segment_of(b), a);
  return of_faces(a, b);
}

std::optional<Circle> circle_through(const SnapFeatures& features, std::size_t edge) {
  Neighbours neighbours;
  for (const SnapFeatures::Edge& e : features.edges) {
    neighbours[key_of(e.from)].push_back(e.to);
    neighbours[key_of(e.to)].push_back(e.from);
  }
  const Vec3 p = features.edges[edge].from, q = features.edges[edge].to;
  std::optional<Circle> best;
  for (const Vec3& r : neighbours.at(key_of(q))) {
    if (r == p) continue;
    std::optional<Circle> circle = circle_of(to_glm(p), to_glm(q), to_glm(r));
    if (!circle || !is_side(*circle, p, q) || !is_side(*circle, q, r)) continue;
    const std::size_t ahead = walk(*circle, neighbours, p, q, p, circle->is_closed);
    circle->corners = 2 + ahead;
    if (!circle->is_closed) {
      bool ignored = false;
      circle->corners += walk(*circle, neighbours, q, p, q, ignored);
    }
    if (circle->corners >= 5 && (!best || circle->corners > best->corners)) best = circle;
  }
  return best;
}

}  // namespace sectile::viewer
