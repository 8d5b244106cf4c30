#include "boolean/near/face_match.h"

#include <algorithm>
#include <tuple>

namespace sectile {
namespace {

bool are_equal(const Frame& p, const Frame& q) {
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      if (!(p.exact(row, column) == q.exact(row, column))) return false;
  return true;
}

}  // namespace

std::optional<Class> FaceMatch::operator()(const FaceAt& of_a, const FaceAt& of_b) {
  const Slot &a = a_.slot(of_a.slot), &b = b_.slot(of_b.slot);
  load(a, of_a.face, loops_of_a_);
  load(b, of_b.face, loops_of_b_);
  if (loops_of_a_.size() != loops_of_b_.size()) return {};
  std::optional<Class> all;
  for (std::size_t l = 0; l < loops_of_a_.size(); ++l) {
    const auto one = compare(*a.block, loops_of_a_[l], *b.block, loops_of_b_[l]);
    if (!one || (all && *all != *one)) return {};
    all = one;
  }
  return all;
}

// Several in the order of their least corners.
void FaceMatch::load(const Slot& slot, FaceId face, std::vector<Loop>& loops) {
  const Brep& brep = slot.block->brep();
  std::size_t count = 0;
  for (LoopId l = brep.outer_loop[face]; l.valid(); l = brep.next_loop[l], ++count) {
    if (count == loops.size()) loops.emplace_back();
    loops[count].clear();
    for_each_in_loop(slot, l, [&](HalfEdgeId h) { loops[count].push_back(slot.start_of(h)); });
  }
  loops.resize(count);
  if (count == 1) return;
  const Geometry& geometry = slot.block->geometry();
  const auto before = [&](PointId p, PointId q) {
    const Vec3 &at = geometry.position(p), &other = geometry.position(q);
    return std::tie(at.x, at.y, at.z) < std::tie(other.x, other.y, other.z);
  };
  for (Loop& loop : loops)
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end(), before), loop.end());
  std::sort(loops.begin(), loops.end(),
            [&](const Loop& p, const Loop& q) { return before(p.front(), q.front()); });
}

std::optional<Class> FaceMatch::compare(const Block& a, const Loop& of_a, const Block& b,
                                        const Loop& of_b) {
  const std::size_t count = of_a.size();
  if (of_b.size() != count) return {};
  std::size_t start = count;
  for (std::size_t i = 0; i < count; ++i) {
    if (!are_same(a, of_a[0], b, of_b[i])) continue;
    if (start < count) return {};
    start = i;
  }
  if (start == count) return {};
  const auto run_along = [&](std::size_t step) {
    std::size_t j = start;
    for (std::size_t i = 1; i < count; ++i) {
      j = (j + step) % count;
      if (!are_same(a, of_a[i], b, of_b[j])) return false;
    }
    return true;
  };
  if (run_along(1)) return Class::on_plus;
  if (run_along(count - 1)) return Class::on_minus;
  return {};
}

// Equal definitions are one place.
bool FaceMatch::are_same(const Block& a, PointId p, const Block& b, PointId q) {
  if (&a == &b && p == q) return true;
  const Geometry &of_a = a.geometry(), &of_b = b.geometry();
  if (!(of_a.position(p) == of_b.position(q))) return false;
  if (of_a.is_explicit(p) && of_b.is_explicit(q)) return true;
  if (!of_a.is_moved(p) || !of_b.is_moved(q)) return false;
  const MovedPoint &from_a = of_a.moved_point_of(p), &from_b = of_b.moved_point_of(q);
  return from_a.local == from_b.local &&
         are_same(*of_a.frames[from_a.frame], *of_b.frames[from_b.frame]);
}

bool FaceMatch::are_same(const Frame& p, const Frame& q) {
  if (&p == &q) return true;
  if (&p != known_frames_.first || &q != known_frames_.second) {
    known_frames_ = {&p, &q};
    known_same_ = are_equal(p, q);
  }
  return known_same_;
}

}  // namespace sectile
