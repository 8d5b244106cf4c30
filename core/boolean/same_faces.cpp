#include "boolean/same_faces.h"

#include <algorithm>
#include <tuple>

#include "geometry/kernel.h"
#include "parallel/parallel.h"
#include "parallel/sort.h"
#include "search/edges_by_line.h"
#include "sectile/errors.h"
#include "storage/geometry_loader.h"

namespace sectile {
namespace {

// A block as it lies in a solid.
struct Placed {
  const Block* block;
  bool turned;
  auto operator<=>(const Placed&) const = default;
};

std::vector<Placed> blocks_of(const SolidData& solid) {
  std::vector<Placed> blocks;
  for (const Slot& slot : solid.slots())
    if (!slot.empty()) blocks.push_back({slot.block.get(), slot.turned});
  std::sort(blocks.begin(), blocks.end());
  return blocks;
}

// Without as many of each as the other one has.
std::vector<Placed> without(const std::vector<Placed>& blocks, const std::vector<Placed>& others) {
  std::vector<Placed> rest;
  std::set_difference(blocks.begin(), blocks.end(), others.begin(), others.end(),
                      std::back_inserter(rest));
  return rest;
}

// The faces of some blocks as loops of points, in one table.
class Faces {
 public:
  void load(const std::vector<Placed>& blocks, Geometry& geometry) {
    for (const Placed& placed : blocks) load(placed, geometry);
  }
  std::size_t size() const { return face_end_.size(); }

  /// Leaves out corners within straight edges: the other solid may have them elsewhere. Were there
  /// any?
  bool leave_out_straight_corners(const Kernel& kernel) {
    std::vector<std::uint8_t> is_straight(corners_.size());
    parallel::loop(0, loop_end_.size(), [&](std::size_t l) {
      const std::size_t begin = loop_begin(l), end = loop_end_[l];
      if (end - begin == 3) return;
      for (std::size_t c = begin; c < end; ++c)
        is_straight[c] = is_within_edge(kernel, corners_[c], corners_[c == begin ? end - 1 : c - 1],
                                        corners_[c + 1 == end ? begin : c + 1]);
    });
    std::size_t kept = 0;
    for (std::size_t l = 0, c = 0; l < loop_end_.size(); ++l) {
      for (; c < loop_end_[l]; ++c)
        if (!is_straight[c]) corners_[kept++] = corners_[c];
      loop_end_[l] = kept;
    }
    const bool any = kept < corners_.size();
    corners_.resize(kept);
    return any;
  }

  /// The same for the same faces, and hardly ever for others; with `number` of each point.
  std::uint64_t fingerprint(const std::vector<std::uint32_t>& number) const {
    std::uint64_t all = 0;
    for (std::size_t f = 0, l = 0, c = 0; f < size(); ++f) {
      std::uint64_t face = 0;
      for (; l < face_end_[f]; ++l) {
        if (c == loop_end_[l]) continue;
        std::uint64_t from = number[corners_[loop_end_[l] - 1].value()];
        for (; c < loop_end_[l]; ++c) {
          const std::uint64_t to = number[corners_[c].value()];
          face += mixed(from << 32 | to);
          from = to;
        }
      }
      all += mixed(face);
    }
    return all;
  }

  /// Per face: its loops, each from its least point on, ascending; with `number` of each point.
  std::vector<std::vector<std::uint32_t>> in_order(const std::vector<std::uint32_t>& number) const {
    std::vector<std::vector<std::uint32_t>> faces(size());
    parallel::loop(0, size(), [&](std::size_t f) {
      std::vector<std::vector<std::uint32_t>> loops;
      for (std::size_t l = f == 0 ? 0 : face_end_[f - 1]; l < face_end_[f]; ++l) {
        std::vector<std::uint32_t> loop;
        for (std::size_t c = loop_begin(l); c < loop_end_[l]; ++c)
          loop.push_back(number[corners_[c].value()]);
        rotate_to_least(loop);
        loops.push_back(std::move(loop));
      }
      std::sort(loops.begin(), loops.end());
      for (const auto& loop : loops) {
        faces[f].push_back(static_cast<std::uint32_t>(loop.size()));
        faces[f].insert(faces[f].end(), loop.begin(), loop.end());
      }
    });
    parallel::sort(faces.begin(), faces.end());
    return faces;
  }

 private:
  static std::uint64_t mixed(std::uint64_t bits) {
    bits = (bits ^ bits >> 29) * 0x9E3779B97F4A7C15u;
    return bits ^ bits >> 32;
  }
  std::size_t loop_begin(std::size_t l) const { return l == 0 ? 0 : loop_end_[l - 1]; }

  void load(const Placed& placed, Geometry& geometry) {
    const Brep& brep = placed.block->brep();
    GeometryLoader loader(placed.block->geometry(), geometry, brep.vertex_count());
    for (const FaceId f : brep.faces()) {
      for (LoopId l = brep.outer_loop[f]; l.valid(); l = brep.next_loop[l]) {
        const auto begin = static_cast<std::ptrdiff_t>(corners_.size());
        for_each_in_loop(brep, l, [&](HalfEdgeId h) {
          corners_.push_back(loader.point(brep.point_of(brep.from(h))));
        });
        if (placed.turned) std::reverse(corners_.begin() + begin, corners_.end());
        loop_end_.push_back(corners_.size());
      }
      face_end_.push_back(loop_end_.size());
    }
  }

  // Where a point occurs more than once, the least of what follows.
  static void rotate_to_least(std::vector<std::uint32_t>& loop) {
    const std::uint32_t least = *std::min_element(loop.begin(), loop.end());
    std::vector<std::uint32_t> best;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (loop[i] != least) continue;
      std::vector<std::uint32_t> turned(loop.begin() + static_cast<std::ptrdiff_t>(i), loop.end());
      turned.insert(turned.end(), loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(i));
      if (best.empty() || turned < best) best = std::move(turned);
    }
    loop = std::move(best);
  }

  std::vector<PointId> corners_;
  std::vector<std::size_t> loop_end_, face_end_;
};

// Per point: the same number for all at one place.
std::vector<std::uint32_t> numbers_of_places(const Geometry& geometry, const Kernel& kernel) {
  std::vector<PointId> order;
  for (std::size_t p = 0; p < geometry.positions.size(); ++p) order.push_back(PointId(p));
  parallel::sort(order.begin(), order.end(), [&](PointId p, PointId q) {
    const Vec3 &a = geometry.position(p), &b = geometry.position(q);
    return std::tie(a.x, a.y, a.z, p) < std::tie(b.x, b.y, b.z, q);
  });
  std::vector<std::uint32_t> number(order.size());
  for (std::size_t from = 0, to; from < order.size(); from = to) {
    for (to = from;
         to < order.size() && geometry.position(order[to]) == geometry.position(order[from]);
         ++to) {
      std::size_t same = from;
      while (!kernel.same_point(order[same], order[to])) ++same;  // at last with itself
      number[order[to].value()] = order[same].value();
    }
  }
  return number;
}

}  // namespace

bool have_same_faces(const SolidData& a, const SolidData& b, const std::atomic<bool>* cancel) {
  const auto check = [cancel] {
    if (cancel && cancel->load(std::memory_order_relaxed)) throw Cancelled();
  };
  const std::vector<Placed> of_a = blocks_of(a), of_b = blocks_of(b);
  Geometry geometry;
  Faces rest_of_a, rest_of_b;
  rest_of_a.load(without(of_a, of_b), geometry);
  check();
  rest_of_b.load(without(of_b, of_a), geometry);
  if (rest_of_a.size() != rest_of_b.size()) return false;
  check();
  const Kernel kernel(geometry);
  const std::vector<std::uint32_t> number = numbers_of_places(geometry, kernel);
  const auto are_the_same = [&] {
    check();
    if (rest_of_a.fingerprint(number) != rest_of_b.fingerprint(number)) return false;
    const auto first = rest_of_a.in_order(number);
    check();
    return first == rest_of_b.in_order(number);
  };
  if (are_the_same()) return true;
  check();
  const bool in_a = rest_of_a.leave_out_straight_corners(kernel),
             in_b = rest_of_b.leave_out_straight_corners(kernel);
  return (in_a || in_b) && are_the_same();
}

}  // namespace sectile
