#include "rounding/rounding_repair.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "geometry/four_points.h"
#include "parallel/parallel.h"
#include "search/approximate.h"

namespace sectile {
namespace {

using approximate::operator-;
using approximate::cross;
using approximate::length;

// How far from its place a vertex may go, in steps, before a coarser grid is better.
constexpr double greatest_reach = 4;
// Of all that meets a triangle, so many are looked at for a change that helps.
constexpr std::size_t most_opponents = 4;
// Where triangles lie pell-mell within a few steps, each change helps a little, and thousands are
// tried for each that does. A coarser grid is better then. What can be mended nearby takes fewer
// tests of pairs than this, which grows with the number of triangles that are faulty at first.
constexpr std::uint64_t tests_per_triangle = 0x2000, tests_at_least = 0x20000;

// Between the two parallel planes nearest to each other that hold four points: those of a face and
// the fourth point, or of two edges that do not meet.
double thickness(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const double volume = six_times_volume(a, b, c, d);
  if (volume == 0) return 0;
  const Vec3 ab = b - a, ac = c - a, ad = d - a, bc = c - b, bd = d - b, cd = d - c;
  double widest = 0;
  for (const Vec3& n : {cross(ab, ac), cross(ab, ad), cross(ac, ad), cross(bc, bd), cross(ab, cd),
                        cross(ac, bd), cross(ad, bc)})
    widest = std::max(widest, length(n));
  return widest > 0 && std::isfinite(widest) ? volume / widest
                                             : std::numeric_limits<double>::infinity();
}

}  // namespace

void ignore_flat(RoundedSurface& rounded, const Kernel& kernel) {
  TriangleSurface& surface = rounded.surface;
  surface.ignored.resize(surface.size());
  parallel::loop(parallel::Range<std::size_t>(0, surface.size(), 4096), [&](const auto& range) {
    for (std::size_t t = range.begin(); t < range.end(); ++t) {
      const PlaneId plane = surface.plane[t];
      const bool flat = kernel.normal(plane, 0) == Sign::zero &&
                        kernel.normal(plane, 1) == Sign::zero &&
                        kernel.normal(plane, 2) == Sign::zero;
      surface.ignored[t] = rounded.alive[t] == 0 || flat;
    }
  });
}

std::vector<std::uint32_t> faulty_triangles(RoundedSurface& rounded, const Kernel& kernel,
                                            const SelfTestControl& control) {
  ignore_flat(rounded, kernel);
  const TriangleSurface& surface = rounded.surface;
  std::vector<std::uint32_t> faulty;
  for (std::uint32_t t = 0; t < surface.size(); ++t)
    if (surface.ignored[t] != 0 && rounded.alive[t] != 0) faulty.push_back(t);
  for (const SelfContact& c : self_contacts(surface, kernel, control)) {
    faulty.push_back(c.first);
    faulty.push_back(c.second);
  }
  std::sort(faulty.begin(), faulty.end());
  faulty.erase(std::unique(faulty.begin(), faulty.end()), faulty.end());
  return faulty;
}

std::vector<std::uint32_t> RoundingRepair::run(std::vector<std::uint32_t> faulty) {
  unite_places(faulty);
  most_tested_ = changes_.tested_pairs() + tests_at_least + tests_per_triangle * faulty.size();
  double reach = 1;
  while (!faulty.empty()) {
    bool better = false;
    std::vector<std::uint32_t> left;
    for (const std::uint32_t t : faulty) {
      const std::uint32_t one[] = {t};
      // A triangle without area counts as long as it lives.
      while (changes_.faults(one) > 0 && improve(t, reach)) better = true;
      if (changes_.faults(one) == 0) continue;
      left.push_back(t);
      for (const std::uint32_t other : changes_.opponents(t)) left.push_back(other);
    }
    std::sort(left.begin(), left.end());
    left.erase(std::unique(left.begin(), left.end()), left.end());
    faulty = std::move(left);
    if (!better) reach *= 2;
    if (reach > greatest_reach || is_hopeless()) break;
  }
  return faulty;
}

// Where sheets have come to lie on each other, they cancel once their vertices are the same.
void RoundingRepair::unite_places(const std::vector<std::uint32_t>& faulty) {
  std::vector<std::uint32_t> vertices;
  for (const std::uint32_t t : faulty)
    if (rounded_.alive[t] != 0)
      vertices.insert(vertices.end(), rounded_.corners[t].begin(), rounded_.corners[t].end());
  const auto key = [&](std::uint32_t v) {
    const Vec3& p = rounded_.position(v);
    return std::tuple(p.x + 0.0, p.y + 0.0, p.z + 0.0, v);
  };
  std::sort(vertices.begin(), vertices.end(),
            [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  std::vector<LocalChanges::Join> joins;
  for (std::size_t i = 0, first = 0; i < vertices.size(); ++i) {
    if (!(rounded_.position(vertices[i]) == rounded_.position(vertices[first]))) first = i;
    if (i != first) joins.push_back({vertices[i], vertices[first]});
  }
  if (joins.empty()) return;
  changes_.join(joins);
  for (const auto& [vertex, into] : joins) gone_to_[vertex] = into;
  merged_ += joins.size();
}

double RoundingRepair::distance(std::uint32_t vertex, const Vec3& to) const {
  return length(to - rounded_.origin[vertex]);
}

bool RoundingRepair::may_go(std::uint32_t vertex, const Vec3& to) const {
  return distance(vertex, to) <= options_.max_move;
}

std::vector<std::uint32_t> RoundingRepair::vertices_near(std::uint32_t triangle) const {
  std::vector<std::uint32_t> vertices(rounded_.corners[triangle].begin(),
                                      rounded_.corners[triangle].end());
  std::vector<std::uint32_t> others = changes_.opponents(triangle);
  others.resize(std::min(others.size(), most_opponents));
  for (const std::uint32_t other : others)
    vertices.insert(vertices.end(), rounded_.corners[other].begin(), rounded_.corners[other].end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

// Keeps a change that leaves less wrong.
bool RoundingRepair::accept() {
  if (options_.cancel && options_.cancel->load(std::memory_order_relaxed)) throw Cancelled();
  if (changes_.is_better()) {
    changes_.keep();
    return true;
  }
  changes_.undo();
  return false;
}

bool RoundingRepair::improve(std::uint32_t triangle, double reach) {
  if (is_hopeless()) return false;
  if (try_flips(triangle, reach)) return true;
  const std::vector<std::uint32_t> vertices = vertices_near(triangle);
  for (const std::uint32_t other : changes_.opponents(triangle))
    if (try_flips(other, reach)) return true;
  return try_merges(vertices, reach) || try_moves(vertices, reach);
}

// Between the surfaces before and after lies the tetrahedron of both triangles: it must be flat but
// for rounding, whatever face each comes from.
bool RoundingRepair::try_flips(std::uint32_t s, double reach) {
  if (rounded_.alive[s] == 0) return false;
  for (std::size_t j = 0; j < 3; ++j) {
    const std::uint32_t t = rounded_.surface.mate[s][j];
    if ((t & TriangleSurface::partial) != 0 || rounded_.alive[t] == 0) continue;
    const auto& corners = rounded_.corners[s];
    const Vec3 &a = rounded_.position(corners[j]), &b = rounded_.position(corners[(j + 1) % 3]),
               &c = rounded_.position(corners[(j + 2) % 3]);
    std::uint32_t far = corners[j];
    for (const std::uint32_t v : rounded_.corners[t])
      if (v != corners[j] && v != corners[(j + 1) % 3]) far = v;
    const Vec3& d = rounded_.position(far);
    const double step = std::max({grid_.step(a), grid_.step(b), grid_.step(c), grid_.step(d)});
    const double moves = thickness(a, b, c, d);
    if (moves > 2 * reach * step || moves > options_.max_move) continue;
    const FaceSource of_s = rounded_.source[s], of_t = rounded_.source[t];
    if (!changes_.flip(s, j)) continue;
    if (!accept()) continue;
    ++flipped_;
    if (moves > widest_flip_) widest_flip_ = moves, widest_flip_at_ = a;
    // Of two faces, the one with the larger triangle there takes both.
    const double area_s = length(cross(b - a, c - a)), area_t = length(cross(b - a, d - a));
    rounded_.source[s] = rounded_.source[t] = area_s > area_t ? of_s : of_t;
    return true;
  }
  return false;
}

bool RoundingRepair::try_merges(const std::vector<std::uint32_t>& vertices, double reach) {
  struct Pair {
    double distance;
    std::uint32_t from, into;
  };
  std::vector<Pair> pairs;
  for (const std::uint32_t u : vertices)
    for (const std::uint32_t v : vertices) {
      if (u == v) continue;
      const Vec3& to = rounded_.position(v);
      const double away = distance(u, to);
      if (away <= 2 * reach * grid_.step(to) && may_go(u, to)) pairs.push_back({away, u, v});
    }
  std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return std::tie(a.distance, a.from, a.into) < std::tie(b.distance, b.from, b.into);
  });
  for (const Pair& pair : pairs) {
    if (!changes_.merge(pair.from, pair.into) || !accept()) continue;
    gone_to_[pair.from] = pair.into;
    ++merged_;
    return true;
  }
  return false;
}

// To the neighbours of each vertex, the nearest to its place first.
std::vector<RoundingRepair::Move> RoundingRepair::moves(const std::vector<std::uint32_t>& vertices,
                                                        double reach) const {
  std::vector<Move> moves;
  for (const std::uint32_t v : vertices) {
    const Vec3 at = rounded_.position(v);
    const double step = reach * grid_.step(at);
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j)
        for (int k = -1; k <= 1; ++k) {
          if (i == 0 && j == 0 && k == 0) continue;
          const Vec3 to = grid_.nearest({at.x + i * step, at.y + j * step, at.z + k * step});
          if (may_go(v, to)) moves.push_back({distance(v, to), v, to});
        }
  }
  std::stable_sort(moves.begin(), moves.end(),
                   [](const Move& a, const Move& b) { return a.distance < b.distance; });
  return moves;
}

bool RoundingRepair::try_moves(const std::vector<std::uint32_t>& vertices, double reach) {
  for (const Move& m : moves(vertices, reach))
    if (changes_.move(m.vertex, m.to) && accept()) return true;
  return false;
}

}  // namespace sectile
