#include "picture/polygon_ears.h"

#include <algorithm>
#include <limits>

namespace sectile::viewer {
namespace {

using Places = std::vector<glm::dvec2>;
using Ring = std::vector<std::uint32_t>;

// Twice the area of a triangle, positive if it turns left.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool cross_each_other(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c,
                      const glm::dvec2& d) {
  return (turn(a, b, c) > 0) != (turn(a, b, d) > 0) && (turn(c, d, a) > 0) != (turn(c, d, b) > 0);
}

bool crosses_ring(const Places& places, const Ring& ring, std::uint32_t from, std::uint32_t to) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::uint32_t a = ring[i], b = ring[(i + 1) % ring.size()];
    const auto touches = [&](std::uint32_t v) {
      return places[v] == places[from] || places[v] == places[to];
    };
    if (touches(a) || touches(b)) continue;
    if (cross_each_other(places[from], places[to], places[a], places[b])) return true;
  }
  return false;
}

// Whether the direction to `target` leaves the corner i of the ring into the polygon.
bool leaves_inwards(const Places& places, const Ring& ring, std::size_t i,
                    const glm::dvec2& target) {
  const std::size_t n = ring.size();
  const glm::dvec2 &before = places[ring[(i + n - 1) % n]], &here = places[ring[i]],
                   &after = places[ring[(i + 1) % n]];
  const bool left_of_first = turn(before, here, target) > 0;
  const bool left_of_second = turn(here, after, target) > 0;
  return turn(before, here, after) > 0 ? left_of_first && left_of_second
                                       : left_of_first || left_of_second;
}

// Joins a hole to the ring by the shortest bridge that crosses neither of them.
void add_bridge(const Places& places, Ring& ring, const Ring& hole, const Loops& later) {
  struct Bridge {
    double length = std::numeric_limits<double>::infinity();
    std::size_t on_ring = 0, on_hole = 0;
  };
  std::vector<Bridge> candidates;
  candidates.reserve(ring.size() * hole.size());
  for (std::size_t h = 0; h < hole.size(); ++h) {
    for (std::size_t r = 0; r < ring.size(); ++r) {
      const glm::dvec2 d = places[hole[h]] - places[ring[r]];
      candidates.push_back({glm::dot(d, d), r, h});
    }
  }
  std::sort(candidates.begin(), candidates.end(), [](const Bridge& a, const Bridge& b) {
    if (a.length != b.length) return a.length < b.length;
    return a.on_ring != b.on_ring ? a.on_ring < b.on_ring : a.on_hole < b.on_hole;
  });
  Bridge best = candidates.front();
  for (const Bridge& bridge : candidates) {
    const std::uint32_t from = ring[bridge.on_ring], to = hole[bridge.on_hole];
    if (!leaves_inwards(places, ring, bridge.on_ring, places[to])) continue;
    if (crosses_ring(places, ring, from, to) || crosses_ring(places, hole, from, to)) continue;
    const bool blocked = std::any_of(later.begin(), later.end(), [&](const Ring& other) {
      return crosses_ring(places, other, from, to);
    });
    if (blocked) continue;
    best = bridge;
    break;
  }
  Ring inserted;
  for (std::size_t i = 0; i <= hole.size(); ++i)
    inserted.push_back(hole[(best.on_hole + i) % hole.size()]);
  inserted.push_back(ring[best.on_ring]);
  ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(best.on_ring) + 1, inserted.begin(),
              inserted.end());
}

class EarCutter {
 public:
  EarCutter(const Places& places, Ring ring) : places_(places), ring_(std::move(ring)) {}

  std::vector<std::array<std::uint32_t, 3>> cut() {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::size_t at = 0;
    while (ring_.size() >= 3) {
      at = next_ear(at);
      const std::size_t n = ring_.size();
      const std::array<std::uint32_t, 3> ear{ring_[(at + n - 1) % n], ring_[at],
                                             ring_[(at + 1) % n]};
      if (turn(places_[ear[0]], places_[ear[1]], places_[ear[2]]) != 0) triangles.push_back(ear);
      ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(at));
      if (!ring_.empty()) at %= ring_.size();
    }
    return triangles;
  }

 private:
  std::size_t next_ear(std::size_t start) const {
    const std::size_t n = ring_.size();
    std::size_t flattest = start;
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t i = (start + k) % n;
      const glm::dvec2 &a = places_[ring_[(i + n - 1) % n]], &b = places_[ring_[i]],
                       &c = places_[ring_[(i + 1) % n]];
      const double area = turn(a, b, c);
      if (area == 0) return i;
      if (area > 0 && is_empty(a, b, c)) return i;
      if (std::abs(area) < smallest) smallest = std::abs(area), flattest = i;
    }
    return flattest;
  }

  bool is_empty(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) const {
    const glm::dvec2 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
    return std::none_of(ring_.begin(), ring_.end(), [&](std::uint32_t v) {
      const glm::dvec2& p = places_[v];
      if (p.x < low.x || p.x > high.x || p.y < low.y || p.y > high.y) return false;
      if (p == a || p == b || p == c) return false;
      return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
    });
  }

  const Places& places_;
  Ring ring_;
};

}  // namespace

std::vector<std::array<std::uint32_t, 3>> ears(const Places& places, const Loops& loops) {
  if (loops.empty()) return {};
  Ring ring = loops.front();
  for (std::size_t i = 1; i < loops.size(); ++i) {
    const Loops later(loops.begin() + static_cast<std::ptrdiff_t>(i) + 1, loops.end());
    if (!loops[i].empty()) add_bridge(places, ring, loops[i], later);
  }
  return EarCutter(places, std::move(ring)).cut();
}

}  // namespace sectile::viewer
