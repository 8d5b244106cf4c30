#include "rounding/separation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "rounding/rounding_repair.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

// So many steps a vertex may go, before a coarser grid is better.
constexpr double greatest_reach = 64;

std::size_t next(std::size_t k) {
  return k < 2 ? k + 1 : 0;
}

// The corner of a triangle that is at a vertex.
std::size_t corner_at(const RoundedSurface::Corners& corners, std::uint32_t vertex) {
  return corners[0] == vertex ? 0 : corners[1] == vertex ? 1 : 2;
}

Vec3 middle_of(const Vec3& a, const Vec3& b) {
  return {a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, a.z / 2 + b.z / 2};
}

}  // namespace

Separation::Result Separation::run(const Rounding& options) {
  find_fans();
  give_fans_vertices();
  divide_pinched_edges();
  std::vector<std::uint32_t> waiting = middles_;
  const std::vector<std::pair<Place, std::uint32_t>> places = places_of_vertices();
  for (std::size_t from = 0, to; from < places.size(); from = to) {
    for (to = from + 1; to < places.size() && places[to].first == places[from].first;) ++to;
    // The last one to be looked at is alone by then.
    for (std::size_t i = to; to > from + 1 && i-- > from;) waiting.push_back(places[i].second);
  }
  if (waiting.empty()) return {};
  for (const auto& [place, vertex] : places) ++many_[place];
  kernel_.refresh();
  ignore_flat(rounded_, kernel_);  // middles may have come to an end of their edge
  LocalChanges changes(rounded_, kernel_, LocalChanges::Asked::is_free);
  for (double reach = 1; !waiting.empty() && reach <= greatest_reach; reach *= 2) {
    std::vector<std::uint32_t> left;
    for (const std::uint32_t v : waiting) {
      if (options.cancel && options.cancel->load(std::memory_order_relaxed)) throw Cancelled();
      if (!move_apart(changes, v, reach)) left.push_back(v);
    }
    waiting = std::move(left);
  }
  return {moved_, std::move(waiting)};
}

void Separation::find_fans() {
  const auto& corners = rounded_.corners;
  fan_.resize(3 * corners.size());
  std::iota(fan_.begin(), fan_.end(), 0u);
  const auto root = [&](std::uint32_t c) {
    while (fan_[c] != c) c = fan_[c] = fan_[fan_[c]];
    return c;
  };
  for (std::uint32_t t = 0; t < corners.size(); ++t) {
    if (rounded_.alive[t] == 0) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t mate = rounded_.surface.mate[t][k];
      for (const std::size_t end : {k, next(k)}) {
        const std::size_t j = corner_at(corners[mate], corners[t][end]);
        const std::uint32_t a = root(static_cast<std::uint32_t>(3 * t + end)),
                            b = root(static_cast<std::uint32_t>(3 * mate + j));
        fan_[std::max(a, b)] = std::min(a, b);
      }
    }
  }
  for (std::uint32_t c = 0; c < fan_.size(); ++c) fan_[c] = root(c);
}

// The first fan keeps the vertex. All have one point until they move: that they are in one place is
// known then without arithmetic.
void Separation::give_fans_vertices() {
  std::vector<std::uint32_t> of_vertex(rounded_.point.size(), 0xFFFFFFFFu);
  std::map<std::uint32_t, std::uint32_t> made;  // per fan
  for (std::uint32_t t = 0; t < rounded_.corners.size(); ++t) {
    if (rounded_.alive[t] == 0) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = rounded_.corners[t][k], fan = fan_[3 * t + k];
      std::uint32_t& first = of_vertex[v];
      if (first == 0xFFFFFFFFu) first = fan;
      if (first == fan) continue;
      const auto [at, is_new] = made.try_emplace(fan, 0);
      if (is_new)
        at->second = add_vertex(rounded_.point[v], rounded_.origin[v], rounded_.is_exact[v] != 0);
      rounded_.corners[t][k] = at->second;
      rounded_.surface.corners[t][k] = rounded_.point[at->second];
      rounded_.surface.settled[t] = 0;
    }
  }
}

std::uint32_t Separation::add_vertex(PointId point, const Vec3& origin, bool is_exact) {
  rounded_.origin.push_back(origin);
  rounded_.is_exact.push_back(is_exact);
  rounded_.point.push_back(point);
  return static_cast<std::uint32_t>(rounded_.point.size() - 1);
}

// Where two wedges have both ends of an edge in common, all but the first one get a vertex between.
void Separation::divide_pinched_edges() {
  std::vector<Edge> edges;
  for (std::uint32_t t = 0; t < rounded_.corners.size(); ++t)
    for (std::uint32_t k = 0; rounded_.alive[t] != 0 && k < 3; ++k) {
      const std::uint32_t a = rounded_.corners[t][k], b = rounded_.corners[t][next(k)];
      if (a < b) edges.push_back({a, b, t, k});
    }
  std::sort(edges.begin(), edges.end());
  std::vector<Edge> pinched;
  for (std::size_t i = 1; i < edges.size(); ++i)
    if (edges[i].low == edges[i - 1].low && edges[i].high == edges[i - 1].high)
      pinched.push_back(edges[i]);
  for (const Edge& e : pinched) {
    // What is left of the triangle, or one that was cut off from it.
    const auto has_edge = [&](std::uint32_t t) {
      return rounded_.corners[t][e.k] == e.low && rounded_.corners[t][next(e.k)] == e.high;
    };
    std::uint32_t t = e.triangle;
    if (!has_edge(t)) {
      const std::vector<std::uint32_t>& pieces = cut_off_[t];
      const auto at = std::find_if(pieces.begin(), pieces.end(), has_edge);
      if (at == pieces.end()) throw InternalError("an edge that is to be divided is lost");
      t = *at;
    }
    divide(t, e.k);
  }
}

void Separation::divide(std::uint32_t s, std::size_t j) {
  const std::uint32_t a = rounded_.corners[s][j], b = rounded_.corners[s][next(j)];
  const std::uint32_t t = rounded_.surface.mate[s][j];
  const std::size_t k = corner_at(rounded_.corners[t], b);
  const Vec3 place = grid_.nearest(middle_of(rounded_.position(a), rounded_.position(b)));
  const std::uint32_t middle = add_vertex(rounded_.geometry.add_point(place),
                                          middle_of(rounded_.origin[a], rounded_.origin[b]), false);
  middles_.push_back(middle);
  divide_half(s, j, middle);
  divide_half(t, k, middle);
  // Of s: a … middle, of the triangle after it: middle … b; of t the other way round.
  const auto last = static_cast<std::uint32_t>(rounded_.corners.size() - 1);
  rounded_.surface.mate[s][j] = last;
  rounded_.surface.mate[last][k] = s;
  rounded_.surface.mate[last - 1][j] = t;
  rounded_.surface.mate[t][k] = last - 1;
}

// (from, to, apex) becomes (from, middle, apex), and (middle, to, apex) is new.
void Separation::divide_half(std::uint32_t t, std::size_t k, std::uint32_t middle) {
  TriangleSurface& surface = rounded_.surface;
  const auto added = static_cast<std::uint32_t>(surface.size());
  const std::size_t to = next(k), apex = next(to);
  const auto known = whole_.find(t);
  const std::uint32_t whole = known == whole_.end() ? t : known->second;
  whole_[added] = whole;
  cut_off_[whole].push_back(added);
  rounded_.corners.push_back(rounded_.corners[t]);
  rounded_.source.push_back(rounded_.source[t]);
  rounded_.alive.push_back(1);
  surface.corners.push_back(surface.corners[t]);
  surface.face.push_back(added);
  surface.mate.push_back(surface.mate[t]);
  surface.settled.push_back(0);
  surface.plane.push_back(PlaneId());
  rounded_.corners[added][k] = rounded_.corners[t][to] = middle;
  surface.corners[added][k] = surface.corners[t][to] = rounded_.point[middle];
  const std::uint32_t across = surface.mate[added][to];
  for (std::size_t j = 0; j < 3; ++j)
    if (surface.mate[across][j] == t &&
        rounded_.corners[across][next(j)] == rounded_.corners[added][to])
      surface.mate[across][j] = added;
  surface.mate[added][apex] = t;
  surface.mate[t][to] = added;
  surface.settled[t] = 0;
  for (const std::uint32_t half : {t, added}) {
    const auto& c = surface.corners[half];
    surface.plane[half] = rounded_.geometry.add_plane(PlaneDefinition::through(c[0], c[1], c[2]));
  }
}

// Sorted; but for the new vertices in the middle of edges.
std::vector<std::pair<Separation::Place, std::uint32_t>> Separation::places_of_vertices() const {
  std::vector<std::uint8_t> used(rounded_.point.size(), 0);
  for (std::uint32_t t = 0; t < rounded_.corners.size(); ++t)
    for (std::size_t k = 0; rounded_.alive[t] != 0 && k < 3; ++k) used[rounded_.corners[t][k]] = 1;
  for (const std::uint32_t v : middles_) used[v] = 0;
  std::vector<std::pair<Place, std::uint32_t>> places;
  for (std::uint32_t v = 0; v < used.size(); ++v)
    if (used[v] != 0) places.push_back({place(v), v});
  std::sort(places.begin(), places.end());
  return places;
}

// Towards the middle of the neighbours, which is where a wedge has most room, and to the 26 places
// around; the nearest first.
std::vector<Vec3> Separation::places_near(const LocalChanges& changes, std::uint32_t vertex,
                                          double step) const {
  const Vec3 at = rounded_.position(vertex);
  Vec3 way{0, 0, 0};
  for (const std::uint32_t t : changes.star(vertex))
    for (const std::uint32_t v : rounded_.corners[t]) {
      const Vec3& p = rounded_.position(v);
      const double away = std::hypot(p.x - at.x, p.y - at.y, p.z - at.z);
      if (away == 0) continue;
      way = {way.x + (p.x - at.x) / away, way.y + (p.y - at.y) / away, way.z + (p.z - at.z) / away};
    }
  const double size = std::hypot(way.x, way.y, way.z);
  std::vector<Vec3> places;
  if (size > 0)
    for (const double far : {1.0, 1.5})
      places.push_back(
          grid_.nearest({at.x + far * step * way.x / size, at.y + far * step * way.y / size,
                         at.z + far * step * way.z / size}));
  for (const double i : {0, -1, 1})
    for (const double j : {0, -1, 1})
      for (const double k : {0, -1, 1})
        places.push_back(grid_.nearest({at.x + i * step, at.y + j * step, at.z + k * step}));
  return places;
}

// What is thinner than a step has room where small coordinates have numbers nearer to each other.
bool Separation::move_apart(LocalChanges& changes, std::uint32_t vertex, double reach) {
  const bool is_middle = std::binary_search(middles_.begin(), middles_.end(), vertex);
  if (!is_middle && many_.at(place(vertex)) == 1) return true;
  const double step = grid_.step(rounded_.position(vertex));
  return move_to_one_of(changes, vertex, places_near(changes, vertex, reach * step)) ||
         (reach > 1 &&
          move_to_one_of(changes, vertex, places_near(changes, vertex, step / (reach * reach))));
}

bool Separation::move_to_one_of(LocalChanges& changes, std::uint32_t vertex,
                                const std::vector<Vec3>& places) {
  const Place before = place(vertex);
  for (const Vec3& to : places) {
    if (many_[{to.x + 0.0, to.y + 0.0, to.z + 0.0}] > 0) continue;
    if (!changes.move(vertex, to)) continue;
    if (!changes.is_free()) {
      changes.undo();
      continue;
    }
    changes.keep();
    ++moved_;
    if (!std::binary_search(middles_.begin(), middles_.end(), vertex)) --many_[before];
    many_[place(vertex)] = 1;
    return true;
  }
  return false;
}

}  // namespace sectile
