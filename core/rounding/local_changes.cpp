#include "rounding/local_changes.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "rounding/triangle_corners.h"
#include "sectile/errors.h"
#include "selftest/wedge_order.h"

namespace sectile {
namespace {

// The edge of a triangle that runs from one vertex to another; 3 if there is none.
std::size_t edge_of(const RoundedSurface::Corners& corners, std::uint32_t from, std::uint32_t to) {
  for (std::size_t k = 0; k < 3; ++k)
    if (corners[k] == from && corners[next_corner(k)] == to) return k;
  return 3;
}

}  // namespace

LocalChanges::LocalChanges(RoundedSurface& rounded, Kernel& kernel, TouchingCones* cones)
    : rounded_(rounded),
      kernel_(kernel),
      pairs_(rounded.surface, kernel),
      cones_(cones),
      near_(rounded, cones) {
  const std::size_t count = rounded.corners.size();
  first_.assign(rounded.point.size() + 1, 0);
  for (const auto& corners : rounded.corners)
    for (const std::uint32_t v : corners) ++first_[v + 1];
  for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
  around_.resize(3 * count);
  std::vector<std::uint32_t> at(first_.begin(), first_.end() - 1);
  for (std::uint32_t t = 0; t < count; ++t)
    for (const std::uint32_t v : rounded.corners[t]) around_[at[v]++] = t;
}

std::vector<std::uint32_t> LocalChanges::star(std::uint32_t vertex) const {
  std::vector<std::uint32_t> found;
  const auto add = [&](std::uint32_t t) {
    if (rounded_.alive[t] != 0 && has_corner(rounded_.corners[t], vertex)) found.push_back(t);
  };
  for (std::uint32_t i = first_[vertex]; i < first_[vertex + 1]; ++i) add(around_[i]);
  if (const auto more = more_.find(vertex); more != more_.end())
    for (const std::uint32_t t : more->second) add(t);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

bool LocalChanges::meet(std::uint32_t s, std::uint32_t t) const {
  ++tested_pairs_;
  if (!pairs_.test(std::min(s, t), std::max(s, t))) return false;
  met_ = {s, t};
  return true;
}

// What was in the way of a change is in the way of others, as a rule, and found before all that is
// near was looked at.
bool LocalChanges::is_free() {
  return !is_met_again() && faults(concerned_, 1) == 0;
}

bool LocalChanges::is_met_again() const {
  const auto [s, t] = met_;
  return s != t && std::binary_search(concerned_.begin(), concerned_.end(), s) &&
         rounded_.alive[s] != 0 && rounded_.alive[t] != 0 && near_.box(s).overlaps(near_.box(t)) &&
         meet(s, t);
}

std::size_t LocalChanges::faults(std::span<const std::uint32_t> triangles, std::size_t most) const {
  std::size_t count = 0;
  for (const std::uint32_t t : triangles) {
    if (count >= most) break;
    if (rounded_.alive[t] == 0) continue;
    if (rounded_.surface.ignored[t] != 0) {
      count += 2;
      continue;
    }
    near_.for_each(t, [&](std::uint32_t other) {
      const bool both = std::binary_search(triangles.begin(), triangles.end(), other);
      if (count >= most || (both && other < t)) return;
      if (meet(t, other)) ++count;
    });
  }
  return count;
}

std::vector<std::uint32_t> LocalChanges::opponents(std::uint32_t triangle) const {
  std::vector<std::uint32_t> found;
  if (rounded_.surface.ignored[triangle] != 0) return found;
  near_.for_each(triangle, [&](std::uint32_t other) {
    if (meet(triangle, other)) found.push_back(other);
  });
  std::sort(found.begin(), found.end());
  return found;
}

bool LocalChanges::any_fixed(std::span<const std::uint32_t> triangles) const {
  if (rounded_.fixed.empty()) return false;
  for (const std::uint32_t t : triangles)
    for (const std::uint32_t v : rounded_.corners[t])
      if (rounded_.fixed[v] != 0) return true;
  return false;
}

void LocalChanges::begin(std::vector<std::uint32_t> triangles, std::uint32_t around) {
  std::sort(triangles.begin(), triangles.end());
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  concerned_ = std::move(triangles);
  if (cones_ == nullptr) count_before(around);
  save_concerned();
}

void LocalChanges::count_before(std::uint32_t around) {
  const auto known = before_at_.find(around);
  before_ = known != before_at_.end() ? known->second : faults(concerned_);
  if (around != no_vertex) before_at_[around] = before_;
}

void LocalChanges::save_concerned() {
  saved_.clear();
  moved_from_ = PointId();
  for (const std::uint32_t t : concerned_) save(t);
  near_.begin(concerned_);
}

void LocalChanges::save(std::uint32_t t) {
  const auto i = static_cast<std::size_t>(t);
  saved_.push_back({t, rounded_.corners[i], rounded_.surface.corners[i], rounded_.surface.plane[i],
                    rounded_.surface.mate[i], rounded_.alive[i], rounded_.surface.ignored[i]});
}

void LocalChanges::renew(std::uint32_t t) {
  std::array<PointId, 3>& points = rounded_.surface.corners[t];
  for (std::size_t k = 0; k < 3; ++k) points[k] = rounded_.point[rounded_.corners[t][k]];
  rounded_.surface.plane[t] =
      rounded_.geometry.add_plane(PlaneDefinition::through(points[0], points[1], points[2]));
  rounded_.surface.settled[t] = 0;
  near_.renew(t);
}

void LocalChanges::kill(std::uint32_t t) {
  rounded_.alive[t] = 0;
  rounded_.surface.ignored[t] = 1;
}

bool LocalChanges::is_flat(std::uint32_t t) const {
  const PlaneId plane = rounded_.surface.plane[t];
  for (int axis = 0; axis < 3; ++axis)
    if (kernel_.normal(plane, axis) != Sign::zero) return false;
  return true;
}

// Two triangles with the same vertices and opposite orientations are nothing.
void LocalChanges::cancel_opposites() {
  struct Turned {
    RoundedSurface::Corners corners;  // ascending
    std::uint32_t triangle;
    bool is_odd;
  };
  std::vector<Turned> sorted;
  for (const std::uint32_t t : concerned_) {
    if (rounded_.alive[t] == 0) continue;
    RoundedSurface::Corners c = rounded_.corners[t];
    const bool is_odd = (c[0] > c[1]) ^ (c[1] > c[2]) ^ (c[0] > c[2]);
    std::sort(c.begin(), c.end());
    sorted.push_back({c, t, is_odd});
  }
  std::sort(sorted.begin(), sorted.end(), [](const Turned& a, const Turned& b) {
    return std::tie(a.corners, a.triangle) < std::tie(b.corners, b.triangle);
  });
  std::vector<std::uint32_t> open;  // of one orientation, those before that are left
  bool open_is_odd = false;
  std::size_t first_open = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const auto& [corners, t, is_odd] = sorted[i];
    if (i > 0 && corners != sorted[i - 1].corners) open.clear(), first_open = 0;
    if (first_open < open.size() && is_odd != open_is_odd) {
      kill(open[first_open++]);
      kill(t);
    } else {
      open_is_odd = is_odd;
      open.push_back(t);
    }
  }
}

void LocalChanges::note_flat() {
  kernel_.refresh();
  for (const std::uint32_t t : concerned_)
    if (rounded_.alive[t] != 0) rounded_.surface.ignored[t] = is_flat(t);
}

void LocalChanges::settle() {
  note_flat();
  // Also of those that lost a neighbour.
  const std::size_t count = saved_.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (rounded_.alive[saved_[i].triangle] != 0) find_mates(saved_[i].triangle);
    const RoundedSurface::Corners old = saved_[i].corners;
    for (std::size_t k = 0; k < 3; ++k) pair_edge(old[k], old[next_corner(k)]);
  }
}

void LocalChanges::find_mates(std::uint32_t t) {
  const RoundedSurface::Corners corners = rounded_.corners[t];
  for (std::size_t k = 0; k < 3; ++k) pair_edge(corners[k], corners[next_corner(k)]);
}

void LocalChanges::pair_edge(std::uint32_t from, std::uint32_t to) {
  std::vector<Side> forward, backward;
  for (const std::uint32_t t : star(from)) {
    if (const std::size_t k = edge_of(rounded_.corners[t], from, to); k < 3)
      forward.push_back({t, k});
    if (const std::size_t k = edge_of(rounded_.corners[t], to, from); k < 3)
      backward.push_back({t, k});
  }
  pair_sides(from, to, std::move(forward), std::move(backward));
}

// Of all triangles that are concerned: each edge once, however many triangles its ends have.
void LocalChanges::pair_edges() {
  struct Edge {
    std::uint32_t low, high;
    Side side;
    bool is_concerned;
  };
  std::vector<std::uint8_t> is_end(rounded_.point.size(), 0);
  for (const std::uint32_t t : concerned_)
    for (const std::uint32_t v : rounded_.corners[t]) is_end[v] = 1;
  std::vector<Edge> edges;
  auto concerned = concerned_.begin();
  for (std::uint32_t t = 0; t < rounded_.corners.size(); ++t) {
    const bool is_concerned = concerned != concerned_.end() && *concerned == t;
    if (is_concerned) ++concerned;
    if (!is_concerned && rounded_.alive[t] == 0) continue;
    const RoundedSurface::Corners& c = rounded_.corners[t];
    for (std::size_t k = 0; k < 3; ++k)
      if (const auto [low, high] = std::minmax(c[k], c[next_corner(k)]);
          low != high && (is_end[low] & is_end[high]) != 0)
        edges.push_back({low, high, {t, k}, is_concerned});
  }
  std::stable_sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::tie(a.low, a.high) < std::tie(b.low, b.high);
  });
  for (auto first = edges.begin(), end = first; first != edges.end(); first = end) {
    std::vector<Side> forward, backward;
    bool is_concerned = false;
    for (; end != edges.end() && end->low == first->low && end->high == first->high; ++end) {
      is_concerned |= end->is_concerned;
      const auto [t, k] = end->side;
      if (rounded_.alive[t] == 0) continue;
      (rounded_.corners[t][k] == first->low ? forward : backward).push_back(end->side);
    }
    if (is_concerned) pair_sides(first->low, first->high, std::move(forward), std::move(backward));
  }
}

// Makes mates of the triangles at an edge; of several wedges, each with its own.
void LocalChanges::pair_sides(std::uint32_t from, std::uint32_t to, std::vector<Side> forward,
                              std::vector<Side> backward) {
  if (forward.size() != backward.size()) throw InternalError("a change has torn the surface open");
  if (forward.size() > 1) sort_wedges(from, to, forward, backward);
  for (std::size_t i = 0; i < forward.size(); ++i) {
    const auto [s, j] = forward[i];
    const auto [t, k] = backward[i];
    if (rounded_.surface.mate[s][j] == t && rounded_.surface.mate[t][k] == s) continue;
    save(s);
    save(t);
    rounded_.surface.mate[s][j] = t;
    rounded_.surface.mate[t][k] = s;
  }
}

// Puts sides of one wedge at one place in the lists, if material alternates with the outside.
void LocalChanges::sort_wedges(std::uint32_t from, std::uint32_t to, std::vector<Side>& forward,
                               std::vector<Side>& backward) const {
  int axis = 0;
  Sign way = Sign::zero;
  for (int k = 0; k < 3 && way == Sign::zero; ++k) {
    axis = k;
    way = kernel_.compare(rounded_.point[from], rounded_.point[to], k);
  }
  if (way == Sign::zero) return;
  const bool up = way == Sign::positive;
  std::vector<SideOfLine> sides;
  const auto count = static_cast<std::uint32_t>(forward.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    sides.push_back({rounded_.surface.plane[forward[i].triangle], up, i});
    sides.push_back({rounded_.surface.plane[backward[i].triangle], !up, count + i});
  }
  if (!sort_around(kernel_, axis, sides)) return;
  std::vector<Side> sorted_forward, sorted_backward;
  const std::size_t first = sides[0].forward ? 1 : 0;
  for (std::size_t i = 0; i < sides.size(); i += 2) {
    const SideOfLine &a = sides[first + i], &b = sides[(first + i + 1) % sides.size()];
    for (const SideOfLine* side : {&a, &b})
      (side->number < count ? sorted_forward : sorted_backward)
          .push_back(side->number < count ? forward[side->number] : backward[side->number - count]);
  }
  forward = std::move(sorted_forward);
  backward = std::move(sorted_backward);
}

bool LocalChanges::move(std::uint32_t vertex, const Vec3& to) {
  if (rounded_.position(vertex) == to) return false;
  std::vector<std::uint32_t> around = star(vertex);
  if (any_fixed(around)) return false;
  begin(std::move(around), vertex);
  moved_vertex_ = vertex;
  moved_from_ = rounded_.point[vertex];
  rounded_.point[vertex] = rounded_.geometry.add_point(to);
  for (const std::uint32_t t : concerned_) renew(t);
  if (cones_ == nullptr) {
    settle();
    return true;
  }
  note_flat();  // neighbours stay neighbours
  cones_->note_move(vertex, concerned_);
  return true;
}

bool LocalChanges::merge(std::uint32_t vertex, std::uint32_t into) {
  if (vertex == into) return false;
  std::vector<std::uint32_t> both = star(vertex);
  const std::vector<std::uint32_t> others = star(into);
  both.insert(both.end(), others.begin(), others.end());
  if (any_fixed(both)) return false;
  begin(std::move(both));
  std::vector<std::uint32_t>& more = more_[into];
  for (const std::uint32_t t : concerned_) {
    RoundedSurface::Corners& corners = rounded_.corners[t];
    if (!has_corner(corners, vertex)) continue;
    const bool vanishes = has_corner(corners, into);
    std::replace(corners.begin(), corners.end(), vertex, into);
    if (vanishes) {
      kill(t);
    } else {
      renew(t);
      more.push_back(t);
    }
  }
  cancel_opposites();
  settle();
  return true;
}

// All at once: one by one, each would look at all triangles that came to its place before.
void LocalChanges::join(std::span<const Join> joins) {
  std::vector<std::uint32_t> goes_to(rounded_.point.size());
  std::iota(goes_to.begin(), goes_to.end(), 0);
  std::vector<std::uint8_t> is_joined(rounded_.point.size(), 0);
  for (const auto& [vertex, into] : joins) {
    goes_to[vertex] = into;
    is_joined[vertex] = is_joined[into] = 1;
  }
  concerned_.clear();
  for (std::uint32_t t = 0; t < rounded_.corners.size(); ++t) {
    const RoundedSurface::Corners& c = rounded_.corners[t];
    if (rounded_.alive[t] != 0 && (is_joined[c[0]] | is_joined[c[1]] | is_joined[c[2]]) != 0)
      concerned_.push_back(t);
  }
  if (any_fixed(concerned_)) throw InternalError("vertices are joined that are to stay");
  save_concerned();
  for (const std::uint32_t t : concerned_) {
    RoundedSurface::Corners& c = rounded_.corners[t];
    for (std::uint32_t& v : c) v = goes_to[v];
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) kill(t);
  }
  cancel_opposites();
  for (const Saved& was : saved_) {
    const std::uint32_t t = was.triangle;
    const RoundedSurface::Corners& c = rounded_.corners[t];
    if (rounded_.alive[t] == 0 || c == was.corners) continue;
    renew(t);
    for (std::size_t k = 0; k < 3; ++k)
      if (c[k] != was.corners[k]) more_[c[k]].push_back(t);
  }
  note_flat();
  pair_edges();
  keep();
}

bool LocalChanges::flip(std::uint32_t s, std::size_t j) {
  const std::uint32_t t = rounded_.surface.mate[s][j], both[] = {s, t};
  if (any_fixed(both)) return false;
  const std::uint32_t a = rounded_.corners[s][j], b = rounded_.corners[s][next_corner(j)],
                      c = rounded_.corners[s][previous_corner(j)];
  const std::size_t k = edge_of(rounded_.corners[t], b, a);
  if (k == 3 || t == s) return false;
  const std::uint32_t d = rounded_.corners[t][previous_corner(k)];
  if (c == d) return false;
  // The other diagonal must be no edge yet.
  for (const std::uint32_t around : star(c))
    if (has_corner(rounded_.corners[around], d)) return false;
  begin({s, t});
  rounded_.corners[s] = {a, d, c};
  rounded_.corners[t] = {d, b, c};
  more_[c].push_back(t);
  more_[d].push_back(s);
  renew(s);
  renew(t);
  settle();
  return true;
}

void LocalChanges::keep() {
  saved_.clear();
  before_at_.clear();
  if (cones_ != nullptr) cones_->keep_move();
  near_.keep();
}

void LocalChanges::undo() {
  for (auto saved = saved_.rbegin(); saved != saved_.rend(); ++saved) {
    const std::uint32_t t = saved->triangle;
    rounded_.corners[t] = saved->corners;
    rounded_.surface.corners[t] = saved->points;
    rounded_.surface.plane[t] = saved->plane;
    rounded_.surface.mate[t] = saved->mate;
    rounded_.alive[t] = saved->alive;
    rounded_.surface.ignored[t] = saved->ignored;
    near_.renew(t);
  }
  saved_.clear();
  if (moved_from_.valid()) rounded_.point[moved_vertex_] = moved_from_;
  if (cones_ != nullptr) cones_->undo_move();
  near_.undo();
}

}  // namespace sectile
