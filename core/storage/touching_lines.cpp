#include "storage/touching_lines.h"

#include <algorithm>
#include <tuple>

#include "geometry/four_points.h"
#include "storage/block_elements.h"

namespace sectile {
namespace {

// A corner of a face at a place where the boundary touches itself, as the face runs.
struct Corner {
  Vec3 at, before, after;
  bool is_convex;  // known to be: that of a triangle
};

bool comes_first(const Vec3& p, const Vec3& q) {
  return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
}

// Collects the corners at some places, in all blocks that have some.
class Collector {
 public:
  explicit Collector(const SolidData& solid) : solid_(solid) {}

  /// False if not all that it takes is given: then nothing is known exactly.
  bool run(std::vector<Corner>& corners) {
    for (const Slot& slot : solid_.slots())
      if (slot.may_touch() && !add_places(*slot.block)) return false;
    std::sort(places_.begin(), places_.end(), comes_first);
    places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
    for (const std::uint32_t s : solid_.touching_slots())
      if (!add_corners(BlockElements(*solid_.slot(s).block), *solid_.slot(s).block, corners))
        return false;
    return true;
  }

 private:
  bool add_places(const Block& block) {
    const Geometry& geometry = block.geometry();
    for (const VertexId v : block.touching_vertices()) {
      const PointId p = block.brep().point_of(v);
      if (!geometry.is_explicit(p)) return false;
      places_.push_back(geometry.position(p));
    }
    return true;
  }

  bool add_corners(const BlockElements& elements, const Block& block,
                   std::vector<Corner>& corners) const {
    std::vector<Vec3> at(block.vertex_count());
    std::vector<std::uint8_t> is_place(at.size()), is_given(at.size());
    elements.each_vertex([&](std::uint32_t v, const Vec3& p, bool is_exact) {
      at[v] = p;
      is_given[v] = is_exact;
      is_place[v] = std::binary_search(places_.begin(), places_.end(), p, comes_first);
    });
    bool all_given = true;
    elements.each_corner([&](std::uint32_t before, std::uint32_t v, std::uint32_t after,
                             bool of_triangle) {
      if (is_place[v] == 0) return;
      all_given = all_given && is_given[v] != 0 && is_given[before] != 0 && is_given[after] != 0;
      corners.push_back({at[v], at[before], at[after], of_triangle});
    });
    return all_given;
  }

  const SolidData& solid_;
  std::vector<Vec3> places_;  // at which the solid touches itself, sorted
};

// Is the way from the corner to q, in the plane of the corner, clearly neither within nor along
// it?
bool clearly_outside(const Corner& c, const NormalOfThree& plane, const Vec3& q) {
  if (!c.is_convex) return false;
  const int axis = main_axis(plane.normal);
  const Sign turn = plane.clear_turn(axis);
  return turn != Sign::zero && (NormalOfThree(c.at, c.after, q).clear_turn(axis) == -turn ||
                                NormalOfThree(c.at, q, c.before).clear_turn(axis) == -turn);
}

// All corners at one place: those of several vertices, or of one from which several edges lead to
// one place.
class Place {
 public:
  explicit Place(std::span<const Corner> corners) : corners_(corners) {}

  bool may_have_lines() {
    constexpr std::size_t many = 100;  // each is looked at with each
    if (!has_single_edges()) return true;
    if (is_one_vertex()) return false;
    return corners_.size() > many || std::any_of(corners_.begin(), corners_.end(),
                                                 [&](const Corner& c) { return may_have_edge(c); });
  }

 private:
  // Does each edge lead to a place of its own? Then it is before one corner and after another.
  bool has_single_edges() {
    for (const Corner& c : corners_) {
      ends_.push_back(c.before);
      ends_.push_back(c.after);
    }
    std::sort(ends_.begin(), ends_.end(), comes_first);
    for (std::size_t i = 0; i < ends_.size(); i += 2)
      if (!(ends_[i] == ends_[i + 1]) || (i > 0 && ends_[i] == ends_[i - 1])) return false;
    ends_.erase(std::unique(ends_.begin(), ends_.end()), ends_.end());
    return true;
  }

  // Then it has several numbers only as the faces around it are in several blocks.
  bool is_one_vertex() const {
    std::vector<Corner> by_before(corners_.begin(), corners_.end());
    const auto before = [](const Corner& c, const Vec3& q) { return comes_first(c.before, q); };
    std::sort(by_before.begin(), by_before.end(),
              [&](const Corner& c, const Corner& d) { return comes_first(c.before, d.before); });
    const Vec3 first = by_before.front().before;
    Vec3 edge = first;
    for (std::size_t count = 1; count <= by_before.size(); ++count) {
      const auto next = std::lower_bound(by_before.begin(), by_before.end(), edge, before);
      if (next == by_before.end() || !(next->before == edge)) return false;
      edge = next->after;
      if (edge == first) return count == by_before.size();
    }
    return false;
  }

  // Other edges than its own, within the corner or along its sides.
  bool may_have_edge(const Corner& c) const {
    const NormalOfThree plane(c.at, c.after, c.before);
    return std::any_of(ends_.begin(), ends_.end(), [&](const Vec3& q) {
      return !(q == c.before) && !(q == c.after) && !plane.clearly_off(q) &&
             !clearly_outside(c, plane, q);
    });
  }

  std::span<const Corner> corners_;
  std::vector<Vec3> ends_;  // of the edges
};

}  // namespace

bool may_touch_in_lines(const SolidData& solid) {
  std::vector<Corner> corners;
  if (!Collector(solid).run(corners)) return true;
  std::sort(corners.begin(), corners.end(),
            [](const Corner& c, const Corner& d) { return comes_first(c.at, d.at); });
  for (std::size_t from = 0, to; from < corners.size(); from = to) {
    for (to = from; to < corners.size() && corners[to].at == corners[from].at;) ++to;
    if (Place(std::span(corners).subspan(from, to - from)).may_have_lines()) return true;
  }
  return false;
}

}  // namespace sectile
