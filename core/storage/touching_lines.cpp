#include "storage/touching_lines.h"

#include <algorithm>
#include <tuple>

#include "geometry/four_points.h"
#include "storage/block_elements.h"
#include "storage/touching_slots.h"

namespace sectile {
namespace {

// A corner of a face at a place where the boundary touches itself, as the face runs.
struct Corner {
  Vec3 at, before, after;
  bool is_convex;  // known to be: that of a triangle
  bool is_given;   // are all three points doubles?
};

bool comes_first(const Vec3& p, const Vec3& q) {
  return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
}

// Collects the corners at some places, in all blocks that have some. Points that are not given are
// known by their rounded positions: different ones are different points.
class CornerCollector {
 public:
  explicit CornerCollector(const SolidData& solid) : solid_(solid) {}

  std::vector<Corner> run() {
    for (const Slot& slot : solid_.slots())
      if (slot.may_touch()) add_places(*slot.block);
    std::sort(places_.begin(), places_.end(), comes_first);
    places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
    for (const std::uint32_t s : solid_.touching_slots()) add_corners(*solid_.slot(s).block);
    return std::move(corners_);
  }

 private:
  void add_places(const Block& block) {
    for (const VertexId v : block.touching_vertices())
      places_.push_back(block.geometry().position(block.brep().point_of(v)));
  }

  void add_corners(const Block& block) {
    const BlockElements elements(block);
    std::vector<Vec3> at(block.vertex_count());
    std::vector<std::uint8_t> is_place(at.size()), is_given(at.size());
    elements.each_vertex([&](std::uint32_t v, const Vec3& p, bool is_exact) {
      at[v] = p;
      is_given[v] = is_exact;
      is_place[v] = std::binary_search(places_.begin(), places_.end(), p, comes_first);
    });
    elements.each_corner(
        [&](std::uint32_t before, std::uint32_t v, std::uint32_t after, bool of_triangle) {
          if (is_place[v] == 0) return;
          const bool all_given = is_given[v] != 0 && is_given[before] != 0 && is_given[after] != 0;
          corners_.push_back({at[v], at[before], at[after], of_triangle, all_given});
        });
  }

  const SolidData& solid_;
  std::vector<Vec3> places_;  // at which the solid touches itself, sorted
  std::vector<Corner> corners_;
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
    return corners_.size() > many || std::ranges::any_of(corners_, [&](const Corner& c) {
             return !c.is_given || may_have_edge(c);
           });
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

std::vector<std::uint32_t> slots_touching_in_lines(const SolidData& solid) {
  std::vector<Corner> corners = CornerCollector(solid).run();
  std::sort(corners.begin(), corners.end(),
            [](const Corner& c, const Corner& d) { return comes_first(c.at, d.at); });
  std::vector<Box> boxes;
  for (std::size_t from = 0, to; from < corners.size(); from = to) {
    for (to = from; to < corners.size() && corners[to].at == corners[from].at;) ++to;
    if (!Place(std::span(corners).subspan(from, to - from)).may_have_lines()) continue;
    Bounds bounds;
    bounds.add(corners[from].at);
    boxes.push_back(bounds.box());
  }
  return boxes.empty() ? std::vector<std::uint32_t>() : slots_near(solid, boxes);
}

}  // namespace sectile
