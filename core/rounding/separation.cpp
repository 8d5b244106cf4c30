#include "rounding/separation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "numbers/none.h"
#include "numbers/threshold.h"
#include "rounding/numbers_in_cone.h"
#include "rounding/rounding_repair.h"
#include "rounding/triangle_corners.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

// So many steps a vertex may go, before a coarser grid is better.
constexpr double reach_of_wedges = 64;
// So many pairs of triangles are tested, and so many more for each vertex, before only places in
// the vertex's cone are looked at.
constexpr std::uint64_t least_tested = threshold<std::uint64_t>(100000, 10),
                        most_tested_for_each = threshold<std::uint64_t>(64, 1);
// And so many more, for each that finds no place there, to find one anywhere.
constexpr std::uint64_t most_tested_out_of_cones = 20000;
// Of a step, where numbers are very much nearer to each other than steps.
constexpr double least_fraction = 0x1p-30;

Vec3 sum_of(const std::vector<Vec3>& all) {
  Vec3 sum{0, 0, 0};
  for (const Vec3& v : all) sum = {sum.x + v.x, sum.y + v.y, sum.z + v.z};
  return sum;
}

// What rounding has left of the middle between two numbers that are not too small, and of a number
// near it.
double rest_of_middle(double a, double b, double near) {
  const double p = a / 2, q = b / 2, sum = p + q, other = sum - p;
  return (sum - near) + ((p - (sum - other)) + (q - other));
}

Vec3 middle_of(const Vec3& a, const Vec3& b) {
  return {a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, a.z / 2 + b.z / 2};
}

}  // namespace

Separation::Result Separation::run() {
  find_fans();
  give_fans_vertices();
  find_places();
  std::vector<CommonEdge> common = edges_in_common();
  find_cones(common);
  divide_edges(common);
  std::vector<std::uint32_t> waiting = vertices_to_move();
  if (waiting.empty()) return {};
  for (const Located& l : located_) ++many_[l.place];
  kernel_.refresh();
  ignore_flat(rounded_, kernel_);  // middles may have come to an end of their edge
  LocalChanges changes(rounded_, kernel_, cones_);
  most_tested_ = least_tested + most_tested_for_each * waiting.size();
  waiting = move_all(changes, std::move(waiting));
  waiting = move_within_cones(changes, move_out_of_cones(changes, waiting));
  std::size_t most = 1;
  for_each_touching([&](std::span<const Located> there) { most = std::max(most, there.size()); });
  for (const CommonEdge& edge : common) most = std::max(most, edge.wedges.size());
  return {moved_, most, std::move(waiting)};
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
      for (const std::size_t end : {k, next_corner(k)}) {
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

// Of wedges that have both ends in common places. Those that have both vertices in common are to be
// divided.
std::vector<Separation::CommonEdge> Separation::edges_in_common() const {
  // Where there are several vertices.
  std::vector<std::uint32_t> place(rounded_.point.size(), none);
  std::uint32_t count = 0;
  for_each_touching([&](std::span<const Located> there) {
    for (const Located& l : there) place[l.vertex] = count;
    ++count;
  });
  std::vector<std::pair<std::array<std::uint32_t, 2>, Edge>> edges;  // by places, or vertices
  for (std::uint32_t t = 0; t < rounded_.corners.size(); ++t)
    for (std::uint32_t k = 0; rounded_.alive[t] != 0 && k < 3; ++k) {
      const std::uint32_t a = rounded_.corners[t][k], b = rounded_.corners[t][next_corner(k)];
      const std::array<std::uint32_t, 2> ends{place[a] == none ? count + a : place[a],
                                              place[b] == none ? count + b : place[b]};
      if (ends[0] < ends[1]) edges.push_back({ends, {a, b, t, k}});
    }
  std::sort(edges.begin(), edges.end());
  std::vector<CommonEdge> common;
  for (auto from = edges.begin(), to = from; from != edges.end(); from = to) {
    for (; to != edges.end() && to->first == from->first;) ++to;
    if (to - from < 2) continue;
    CommonEdge& edge = common.emplace_back();
    for (auto e = from; e != to; ++e) edge.wedges.push_back(e->second);
  }
  return common;
}

void Separation::find_cones(std::vector<CommonEdge>& edges) {
  kernel_.refresh();
  std::vector<TouchingCones::Corner> corners;
  for_each_touching([&](std::span<const Located> there) {
    corners.clear();
    for (const Located& l : there) corners.push_back(l.corner);
    cones_.add_place(corners);
  });
  for (CommonEdge& edge : edges) {
    corners.clear();
    for (const Edge& e : edge.wedges) corners.push_back({e.triangle, e.k});
    edge.cones = cones_.add_edge(corners);
  }
  cones_.find_members();
}

// All wedges but the first one between two vertices get one between the ends.
void Separation::divide_edges(const std::vector<CommonEdge>& edges) {
  for (const CommonEdge& edge : edges)
    for (std::size_t i = 1; i < edge.wedges.size(); ++i) {
      const Edge &before = edge.wedges[i - 1], &wedge = edge.wedges[i];
      if (wedge.low != before.low || wedge.high != before.high) continue;
      const std::uint32_t middle = divide(triangle_with(edge.wedges[i]), edge.wedges[i].k);
      const Vec3 &a = rounded_.position(wedge.low), &b = rounded_.position(wedge.high),
                 &m = rounded_.position(middle);
      middles_.push_back(middle);
      to_edge_.push_back({rest_of_middle(a.x, b.x, m.x), rest_of_middle(a.y, b.y, m.y),
                          rest_of_middle(a.z, b.z, m.z)});
      if (edge.cones[i].site != TouchingCones::none) cones_.put_on_edge(middle, edge.cones[i]);
    }
}

// What is left of the triangle, or one that was cut off from it.
std::uint32_t Separation::triangle_with(const Edge& e) const {
  const auto has_edge = [&](std::uint32_t t) {
    return rounded_.corners[t][e.k] == e.low && rounded_.corners[t][next_corner(e.k)] == e.high;
  };
  if (has_edge(e.triangle)) return e.triangle;
  if (const auto cut = cut_off_.find(e.triangle); cut != cut_off_.end())
    for (const std::uint32_t piece : cut->second)
      if (has_edge(piece)) return piece;
  throw InternalError("an edge that is to be divided is lost");
}

std::uint32_t Separation::divide(std::uint32_t s, std::size_t j) {
  const std::uint32_t a = rounded_.corners[s][j], b = rounded_.corners[s][next_corner(j)];
  const std::uint32_t t = rounded_.surface.mate[s][j];
  const std::size_t k = corner_at(rounded_.corners[t], b);
  const Vec3 place = grid_.nearest(middle_of(rounded_.position(a), rounded_.position(b)));
  const std::uint32_t middle = add_vertex(rounded_.geometry.add_point(place),
                                          middle_of(rounded_.origin[a], rounded_.origin[b]), false);
  divide_half(s, j, middle);
  divide_half(t, k, middle);
  // Of s: a … middle, of the triangle after it: middle … b; of t the other way round.
  const auto last = static_cast<std::uint32_t>(rounded_.corners.size() - 1);
  rounded_.surface.mate[s][j] = last;
  rounded_.surface.mate[last][k] = s;
  rounded_.surface.mate[last - 1][j] = t;
  rounded_.surface.mate[t][k] = last - 1;
  return middle;
}

// (from, to, apex) becomes (from, middle, apex), and (middle, to, apex) is new.
void Separation::divide_half(std::uint32_t t, std::size_t k, std::uint32_t middle) {
  TriangleSurface& surface = rounded_.surface;
  const auto added = static_cast<std::uint32_t>(surface.size());
  const std::size_t to = next_corner(k), apex = next_corner(to);
  const auto known = whole_.find(t);
  const std::uint32_t whole = known == whole_.end() ? t : known->second;
  whole_[added] = whole;
  cut_off_[whole].push_back(added);
  cones_.divide(t, added);
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
        rounded_.corners[across][next_corner(j)] == rounded_.corners[added][to])
      surface.mate[across][j] = added;
  surface.mate[added][apex] = t;
  surface.mate[t][to] = added;
  surface.settled[t] = 0;
  for (const std::uint32_t half : {t, added}) {
    const auto& c = surface.corners[half];
    surface.plane[half] = rounded_.geometry.add_plane(PlaneDefinition::through(c[0], c[1], c[2]));
  }
}

void Separation::find_places() {
  std::vector<std::uint8_t> seen(rounded_.point.size(), 0);
  for (std::uint32_t t = 0; t < rounded_.corners.size(); ++t)
    for (std::uint32_t k = 0; rounded_.alive[t] != 0 && k < 3; ++k) {
      const std::uint32_t v = rounded_.corners[t][k];
      if (std::exchange(seen[v], 1) == 0) located_.push_back({place(v), v, {t, k}});
    }
  std::sort(located_.begin(), located_.end(), [](const Located& a, const Located& b) {
    return std::tie(a.place, a.vertex) < std::tie(b.place, b.vertex);
  });
}

// Visits the vertices at each place where there are several.
template <class Visit>
void Separation::for_each_touching(const Visit& visit) const {
  const std::span<const Located> all = located_;
  for (std::size_t from = 0, to; from < all.size(); from = to) {
    for (to = from + 1; to < all.size() && all[to].place == all[from].place;) ++to;
    if (to - from > 1) visit(all.subspan(from, to - from));
  }
}

// The last one to be looked at in a place is alone by then.
std::vector<std::uint32_t> Separation::vertices_to_move() const {
  std::vector<std::uint32_t> waiting = middles_;
  for_each_touching([&](std::span<const Located> there) {
    for (std::size_t i = there.size(); i-- > 0;) waiting.push_back(there[i].vertex);
  });
  return waiting;
}

// A number some way off, but not the same one if there is another within four ways: what stays on a
// face of its wedge, where numbers are far from each other, may touch others there.
double Separation::leaving(double from, double way) const {
  double to = grid_.nearest(from + way);
  for (const double far : {2.0, 4.0})
    if (to == from) to = grid_.nearest(from + far * way);
  return to;
}

// To the neighbours: their sum is towards where a wedge has most room.
std::vector<Vec3> Separation::ways_from(const LocalChanges& changes, std::uint32_t vertex) const {
  const Vec3 at = rounded_.position(vertex);
  std::vector<Vec3> ways;
  for (const std::uint32_t t : changes.star(vertex))
    for (const std::uint32_t v : rounded_.corners[t]) {
      const Vec3& p = rounded_.position(v);
      const double away = std::hypot(p.x - at.x, p.y - at.y, p.z - at.z);
      if (away > 0) ways.push_back({(p.x - at.x) / away, (p.y - at.y) / away, (p.z - at.z) / away});
    }
  return ways;
}

// Towards the middle of the neighbours, and to the 26 places around; the nearest first.
std::vector<Vec3> Separation::places_near(const LocalChanges& changes, std::uint32_t vertex,
                                          double step) const {
  const Vec3 at = rounded_.position(vertex);
  Vec3 way = sum_of(ways_from(changes, vertex));
  const double size = std::hypot(way.x, way.y, way.z);
  std::vector<Vec3> places;
  if (size > 0) {
    way = {step * way.x / size, step * way.y / size, step * way.z / size};
    places.push_back({leaving(at.x, way.x), leaving(at.y, way.y), leaving(at.z, way.z)});
    places.push_back(grid_.nearest({at.x + way.x, at.y + way.y, at.z + way.z}));
    places.push_back(grid_.nearest({at.x + 1.5 * way.x, at.y + 1.5 * way.y, at.z + 1.5 * way.z}));
  }
  for (const double i : {0, -1, 1})
    for (const double j : {0, -1, 1})
      for (const double k : {0, -1, 1})
        places.push_back(grid_.nearest({at.x + i * step, at.y + j * step, at.z + k * step}));
  return places;
}

// Within a thin wedge there are numbers only here and there.
std::vector<Vec3> Separation::places_within(const LocalChanges& changes, std::uint32_t vertex,
                                            double far) const {
  const Vec3 amid = sum_of(ways_from(changes, vertex));
  const double size = std::hypot(amid.x, amid.y, amid.z);
  if (!(size > 0)) return {};
  const ThinCone cone{rounded_.position(vertex),
                      to_edge(vertex),
                      cones_.inward(vertex),
                      {amid.x / size, amid.y / size, amid.z / size}};
  return numbers_in_cone(grid_, cone, far, least_fraction * far);
}

// Those are left that found no place. A cone of very many at one place is left only as long as not
// too much was tested for that.
std::vector<std::uint32_t> Separation::move_all(LocalChanges& changes,
                                                std::vector<std::uint32_t> waiting) {
  for (double reach = 1; !waiting.empty() && reach <= reach_of_wedges; reach *= 2) {
    changes.leave_room(2 * reach * greatest_step(waiting));
    std::erase_if(waiting, [&](std::uint32_t v) {
      check_cancel();
      return move_apart(changes, v, reach);
    });
  }
  return waiting;
}

// Where nothing else helps, they may go farther if they need not be tested against all others.
// Those are left that have no room for that.
std::vector<std::uint32_t> Separation::move_within_cones(LocalChanges& changes,
                                                         std::vector<std::uint32_t> waiting) {
  std::vector<std::uint32_t> left;
  for (double reach = 2 * reach_of_wedges; !waiting.empty(); reach *= 2) {
    changes.leave_room(4 * reach * greatest_step(waiting));
    std::erase_if(waiting, [&](std::uint32_t v) {
      check_cancel();
      const double far = reach * grid_.step(rounded_.position(v));
      if (is_alone(v)) return true;
      if (cones_.cones_beside(v) == 0 || !(far < room_around(changes, v))) {
        left.push_back(v);
        return true;
      }
      return move_to_one_of(changes, v, places_within(changes, v, far));
    });
  }
  return left;
}

// Where one vertex finds no place, the others there are not looked at any more: it is too narrow.
std::vector<std::uint32_t> Separation::move_out_of_cones(
    LocalChanges& changes, const std::vector<std::uint32_t>& waiting) {
  const auto has_tried_all = [&](std::uint32_t v) { return may_leave_cone(changes, v); };
  if (std::any_of(waiting.begin(), waiting.end(), has_tried_all)) return waiting;
  most_tested_ = changes.tested_pairs() + most_tested_out_of_cones * waiting.size();
  std::set<Place> narrow;
  std::vector<std::uint32_t> cramped;
  for (const std::uint32_t v : waiting) {
    check_cancel();
    bool is_moved = false;
    if (!narrow.contains(place(v)))
      for (double reach = 1; !is_moved && reach <= reach_of_wedges; reach *= 2)
        is_moved = move_apart(changes, v, reach);
    if (is_moved) continue;
    narrow.insert(place(v));
    cramped.push_back(v);
  }
  return cramped;
}

double Separation::greatest_step(const std::vector<std::uint32_t>& vertices) const {
  double step = 0;
  for (const std::uint32_t v : vertices) step = std::max(step, grid_.step(rounded_.position(v)));
  return step;
}

void Separation::check_cancel() const {
  if (options_.cancel && options_.cancel->load(std::memory_order_relaxed)) throw Cancelled();
}

// As far as the nearest neighbour.
double Separation::room_around(const LocalChanges& changes, std::uint32_t vertex) const {
  const Vec3 at = rounded_.position(vertex);
  double room = std::numeric_limits<double>::infinity();
  for (const std::uint32_t t : changes.star(vertex))
    for (const std::uint32_t v : rounded_.corners[t]) {
      const Vec3& p = rounded_.position(v);
      const double away = std::hypot(p.x - at.x, p.y - at.y, p.z - at.z);
      if (v != vertex) room = std::min(room, away);
    }
  return room;
}

// Of the neighbours' coordinates.
double Separation::step_around(const LocalChanges& changes, std::uint32_t vertex) const {
  double step = 0;
  for (const std::uint32_t t : changes.star(vertex))
    for (const std::uint32_t v : rounded_.corners[t])
      step = std::max(step, grid_.step(rounded_.position(v)));
  return step;
}

// Beside the origin, steps are as small as numbers can be: a fraction of those of the neighbours is
// tried first, as there are numbers in all directions. What is thinner than a step has room where
// small coordinates have numbers nearer to each other.
bool Separation::move_apart(LocalChanges& changes, std::uint32_t vertex, double reach) {
  if (is_alone(vertex)) return true;
  const double step = grid_.step(rounded_.position(vertex));
  const double fraction = least_fraction * step_around(changes, vertex);
  const auto goes = [&](double far) {
    return move_to_one_of(changes, vertex, places_near(changes, vertex, far));
  };
  const auto goes_steps = [&](double of) {
    return goes(reach * of) || (reach > 1 && goes(of / (reach * reach)));
  };
  return (fraction > step && goes_steps(fraction)) || goes_steps(step) ||
         (!may_leave_cone(changes, vertex) &&
          move_to_one_of(changes, vertex,
                         places_within(changes, vertex, reach * std::max(step, fraction))));
}

bool Separation::move_to_one_of(LocalChanges& changes, std::uint32_t vertex,
                                const std::vector<Vec3>& places) {
  const Place before = place(vertex);
  const Vec3 at = rounded_.position(vertex), edge = to_edge(vertex);
  for (const Vec3& to : places) {
    const bool must_stay = !may_leave_cone(changes, vertex);
    const Vec3 way{to.x - at.x - edge.x, to.y - at.y - edge.y, to.z - at.z - edge.z};
    if (must_stay && !cones_.seems_inside(vertex, way)) continue;
    if (is_taken(to) || !changes.move(vertex, to)) continue;
    if ((must_stay && !cones_.has_moved_inside()) || !changes.is_free()) {
      changes.undo();
      continue;
    }
    changes.keep();
    ++moved_;
    if (!is_middle(vertex)) --many_[before];
    many_[place(vertex)] = 1;
    return true;
  }
  return false;
}

// From where a vertex is to the place or the edge that its wedge has there.
Vec3 Separation::to_edge(std::uint32_t vertex) const {
  const auto at = std::lower_bound(middles_.begin(), middles_.end(), vertex);
  if (at == middles_.end() || *at != vertex) return {0, 0, 0};
  return to_edge_[static_cast<std::size_t>(at - middles_.begin())];
}

bool Separation::is_middle(std::uint32_t vertex) const {
  return std::binary_search(middles_.begin(), middles_.end(), vertex);
}

bool Separation::is_alone(std::uint32_t vertex) const {
  return !is_middle(vertex) && many_.at(place(vertex)) == 1;
}

bool Separation::is_taken(const Vec3& p) const {
  const auto at = many_.find({p.x + 0.0, p.y + 0.0, p.z + 0.0});
  return at != many_.end() && at->second > 0;
}

bool Separation::may_leave_cone(const LocalChanges& changes, std::uint32_t vertex) const {
  return changes.tested_pairs() <= most_tested_ || cones_.cones_beside(vertex) == 0;
}

}  // namespace sectile
